#include <fairlight/validation/claims/claims.h>

namespace fairlight {

void add_second_order_claims(std::vector<Claim>&) {}

}  // namespace fairlight
