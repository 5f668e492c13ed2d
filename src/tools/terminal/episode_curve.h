#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace crowd {

/// @brief A quantity over episodes, in bounded memory: means over bins of equally many episodes. When all bins are in
/// use, neighbours are joined, and a bin holds twice as many episodes from then on.
class EpisodeCurve {
 public:
  /// @param bins greatest number of bins; even, at least 2
  explicit EpisodeCurve(std::size_t bins = 512) : most_(bins) {}

  /// @brief Adds the value of the next episode; NaN: it has none.
  void add(double value);

  std::uint64_t episodes() const { return episodes_; }
  /// @brief Number of episodes in a bin; the last bin may have fewer.
  std::uint64_t binSize() const { return bin_size_; }
  /// @brief Returns the means of `points` equal parts of the curve; NaN in a part without values. If there are fewer
  /// bins than points, neighbouring points have equal values.
  std::vector<double> means(std::size_t points) const;

 private:
  struct Bin {
    double sum = 0.0;
    std::uint64_t count = 0;  // of values
  };
  void joinNeighbours();

  std::size_t most_;
  std::vector<Bin> bins_;
  std::uint64_t bin_size_ = 1;
  std::uint64_t episodes_ = 0;
};

}  // namespace crowd
