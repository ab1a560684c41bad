#include <fairlight/validation/faults/catalogue.h>

namespace fairlight {

std::vector<Fault> camera_faults() { return {}; }

}  // namespace fairlight
