#include <fairlight/validation/faults/catalogue.h>

namespace fairlight {

std::vector<Fault> microfacet_faults() { return {}; }

}  // namespace fairlight
