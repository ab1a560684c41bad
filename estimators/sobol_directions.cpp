#include <boost/random/sobol.hpp>

#include <fairlight/estimators/sobol.h>

namespace fairlight {

// Boost's engine counts in Gray code and skips point 0: its point 2^(k+1) - 1 has the code with bit k alone.
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
