#include <png.h>

#include <array>
#include <string>

#include "geometry/limits.h"
#include "maps/map_image.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

/// Owns what libpng allocates while an image is read.
class PngReader {
 public:
  explicit PngReader(std::string_view content) : content_(content) {
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
    requireData();
    image.channels = chooseFormat();
    if (std::uint64_t{image.width} * image.height * image.channels > limits::CELLS) {
      throw InputError("expected an image of up to " + std::to_string(limits::CELLS) + " samples, got " + size() +
                       " of " + std::to_string(image.channels));
    }
    image.samples.resize(PNG_IMAGE_SIZE(image_));
    require(png_image_finish_read(&image_, nullptr, image.samples.data(), 0, nullptr));
    return image;
  }

 private:
  std::string size() const { return std::to_string(image_.width) + " x " + std::to_string(image_.height) + " pixels"; }
  /// The header may lie: throws if the file cannot contain so many pixels.
  void requireData() const {
    constexpr std::array<std::uint64_t, 7> SAMPLES = {1, 0, 3, 1, 2, 0, 4};  // of a pixel, by the type of colours
    constexpr std::uint64_t BEST_COMPRESSION = 1032;                         // of zlib
    const auto bits = static_cast<std::uint64_t>(content_[24]) * SAMPLES.at(static_cast<std::size_t>(content_[25]));
    const std::uint64_t row = 1 + (image_.width * bits + 7) / 8;  // [bytes]
    const std::uint64_t least = image_.height * row / BEST_COMPRESSION;
    if (content_.size() >= least) return;
    throw InputError("expected at least " + std::to_string(least) + " bytes for " + size() + ", got " +
                     std::to_string(content_.size()));
  }
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

  std::string_view content_;
  png_image image_ = {};
};

}  // namespace

MapImage decodePng(std::string_view content) { return PngReader(content).read(); }

}  // namespace crowd
