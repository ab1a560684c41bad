#include <boost/random/sobol.hpp>

#include <fairlight/estimators/sobol.h>

namespace fairlight {

// Boost's engine counts in Gray code and skips point 0. Its point 2^(k+1) - 1 has the Gray code
// with only bit k set.
const SobolDirections& sobol_directions() {
  static const auto directions = [] {
    SobolDirections matrix{};
    boost::random::sobol_engine<std::uint32_t, 32> engine(sobol_dimensions);
    for (std::size_t k = 0; k < 32; ++k) {
      engine.seed(static_cast<std::uint32_t>((std::uint64_t{2} << k) - 2));
      for (auto& dimension : matrix) dimension[k] = engine();
    }
    return matrix;
  }();
  return directions;
}

}  // namespace fairlight
