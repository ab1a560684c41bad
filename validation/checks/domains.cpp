#include <numbers>

#include <fairlight/validation/checks/parameters.h>

namespace fairlight {

// One row for each parameter that claims draw, with the domain that docs/estimators.md states. Keep
// the components in alphabetical order.
const std::vector<ParameterDomain>& parameter_domains() {
  constexpr double turn = 2 * std::numbers::pi;
  static const std::vector<ParameterDomain> domains{
      {"FresnelReflectance", "eta", "1", 0, 1e6, ""},
      {"FresnelReflectance", "k", "1", 0, 1e6, ""},
      {"RoughConductor", "azimuth of out", "rad", 0, turn, ""},
      {"RoughConductor", "height of out", "1", 1e-27, 1, ""},
      {"RoughConductor", "roughness along x", "1", 1e-4, 1, ""},
      {"RoughConductor", "roughness along y", "1", 1e-4, 1, ""},
      {"SchlickReflectance", "reflectance", "1", 0, 1, ""},
  };
  return domains;
}

}  // namespace fairlight
