#include <fairlight/validation/faults/catalogue.h>

namespace fairlight {

std::vector<Fault> random_faults() { return {}; }

}  // namespace fairlight
