#include <algorithm>
#include <cmath>
#include <limits>

#include <fairlight/validation/checks/draws.h>

namespace fairlight {

std::vector<Reference> rounded_references(std::vector<Reference> references, double rounding) {
  for (Reference& r : references) {
    const double slack = 4 * rounding * std::max(std::abs(r.lower), std::abs(r.upper));
    r.lower -= r.lower == 0 ? 0 : slack;
    r.upper += slack;
    r.rounding += rounding;
  }
  return references;
}

std::vector<Reference> replicate_references(std::vector<Reference> references, std::uint32_t n) {
  for (Reference& r : references) {
    const double slack = n * ulp<double> * std::max(std::abs(r.lower), std::abs(r.upper));
    r.lower -= r.lower == 0 ? 0 : slack;
    r.upper += slack;
  }
  return references;
}

DrawBlock draws_at_once(std::size_t lanes, std::size_t channel_count, MakePacket make) {
  return [=, places = std::vector<double*>(channel_count),
          kept = std::vector<std::vector<double>>(channel_count, std::vector<double>(lanes)),
          made = std::numeric_limits<std::uint64_t>::max()](std::uint64_t first,
                                                            std::vector<std::vector<double>>& channels) mutable {
    const std::size_t size = channels[0].size();
    for (std::size_t i = 0, count = lanes; i < size; i += count) {
      const std::uint64_t number = (first + i) / lanes;
      const std::size_t lane = (first + i) % lanes;
      count = std::min(lanes - lane, size - i);
      const bool whole = count == lanes;
      for (std::size_t c = 0; c < channels.size(); ++c) places[c] = whole ? &channels[c][i] : kept[c].data();
      if (whole || number != made) make(lanes * number, places);
      if (whole) continue;
      made = number;
      for (std::size_t c = 0; c < channels.size(); ++c) {
        std::copy_n(kept[c].begin() + static_cast<std::ptrdiff_t>(lane), count,
                    channels[c].begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
  };
}

}  // namespace fairlight
