#include <fairlight/validation/faults/catalogue.h>

namespace fairlight {

std::vector<Fault> light_faults() { return {}; }

}  // namespace fairlight
