#include <fairlight/validation/checks/parameters.h>

namespace fairlight {

// One row for each parameter that claims draw, with the domain that docs/estimators.md states. Keep
// the components in alphabetical order.
const std::vector<ParameterDomain>& parameter_domains() {
  static const std::vector<ParameterDomain> domains{
      {"SchlickReflectance", "reflectance", "1", 0, 1, ""},
  };
  return domains;
}

}  // namespace fairlight
