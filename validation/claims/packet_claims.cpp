// The rows of the registry for one instruction set. The build compiles this file and all of claims/
// for it, and defines FAIRLIGHT_ENTRY as the name of the entry.

#include <fairlight/validation/claims/claims.h>

extern "C" void FAIRLIGHT_ENTRY(std::vector<fairlight::Claim>& claims) { fairlight::add_claims(claims); }
