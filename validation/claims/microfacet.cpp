#include <fairlight/validation/claims/claims.h>

namespace fairlight {

void add_microfacet_claims(std::vector<Claim>&) {}

}  // namespace fairlight
