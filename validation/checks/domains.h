#pragma once

#include <fairlight/validation/checks/parameters.h>

namespace fairlight {

/// Parts of parameter_domains().
std::vector<ParameterDomain> domains_of_lights();
std::vector<ParameterDomain> domains_of_combinators();

}  // namespace fairlight
