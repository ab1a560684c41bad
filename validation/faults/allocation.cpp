#include <fairlight/validation/faults/catalogue.h>

namespace fairlight {

std::vector<Fault> allocation_faults() { return {}; }

}  // namespace fairlight
