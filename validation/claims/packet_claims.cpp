// The rows of the registry for one instruction set, which the build compiles this file and all of claims/ for, and names.

#include <fairlight/validation/claims/claims.h>

extern "C" void FAIRLIGHT_ENTRY(std::vector<fairlight::Claim>& claims) { fairlight::add_claims(claims); }
