#include <png.h>

#include "social_crowd/common/errors.h"
#include "world/map_image.h"

namespace crowd {
namespace {

/// Owns what libpng allocates while an image is read.
class PngReader {
 public:
  explicit PngReader(std::string_view content) {
    image_.version = PNG_IMAGE_VERSION;
    require(png_image_begin_read_from_memory(&image_, content.data(), content.size()));
  }
  ~PngReader() { png_image_free(&image_); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  MapImage read() {
    MapImage image;
    image.width = image_.width;
    image.height = image_.height;
    requireImageSize(image.width, image.height);
    image.channels = chooseFormat();
    image.samples.resize(PNG_IMAGE_SIZE(image_));
    require(png_image_finish_read(&image_, nullptr, image.samples.data(), 0, nullptr));
    return image;
  }

 private:
  /// Selects the form in which pixels are to be read; returns its number of channels.
  std::uint32_t chooseFormat() {
    const bool has_alpha = (image_.format & PNG_FORMAT_FLAG_ALPHA) != 0;
    const bool has_colour = (image_.format & PNG_FORMAT_FLAG_COLOR) != 0;
    const png_uint_32 opaque = has_colour ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY;
    image_.format = has_alpha ? PNG_FORMAT_RGBA : opaque;
    image_.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // samples of 16 bits are scaled as those of 8 bits are
    return PNG_IMAGE_PIXEL_CHANNELS(image_.format);
  }
  /// A warning does not fail; pixels are then complete.
  void require(int success) const {
    if (success == 0) throw InputError(std::string("not a valid PNG image: ") + image_.message);
  }

  png_image image_ = {};
};

}  // namespace

MapImage decodePng(std::string_view content) { return PngReader(content).read(); }

}  // namespace crowd
