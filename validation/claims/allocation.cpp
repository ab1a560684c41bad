#include <fairlight/validation/claims/claims.h>

namespace fairlight {

void add_allocation_claims(std::vector<Claim>&) {}

}  // namespace fairlight
