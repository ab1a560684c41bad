#include <stdexcept>

#include <fnmatch.h>

#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/registry.h>

namespace fairlight {
namespace {

std::vector<Claim> build() {
  std::vector<Claim> claims;
  add_claims(claims);
  return claims;
}

bool matches(const std::string& pattern, const std::string& name) {
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0 || name.starts_with(pattern + ".");
}

}  // namespace

const std::vector<Claim>& registry() {
  static const std::vector<Claim> claims = build();
  return claims;
}

std::vector<const Claim*> select_claims(const std::vector<std::string>& patterns) {
  std::vector<bool> chosen(registry().size(), patterns.empty());
  for (const std::string& pattern : patterns) {
    bool found = false;
    for (std::size_t i = 0; i < registry().size(); ++i) {
      if (!matches(pattern, registry()[i].name)) continue;
      chosen[i] = found = true;
    }
    if (found) continue;
    std::string known;
    for (const Claim& claim : registry()) known += " " + claim.name;
    throw std::invalid_argument("no claim matches \"" + pattern + "\" (there are:" + known + ")");
  }
  std::vector<const Claim*> claims;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (chosen[i]) claims.push_back(&registry()[i]);
  }
  return claims;
}

}  // namespace fairlight
