#include <fairlight/validation/faults/catalogue.h>

namespace fairlight {

std::vector<Fault> combinator_faults() { return {}; }

}  // namespace fairlight
