#include <fairlight/validation/faults/catalogue.h>

namespace fairlight {

std::vector<Fault> material_faults() { return {}; }

}  // namespace fairlight
