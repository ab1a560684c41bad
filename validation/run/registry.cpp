#include <map>
#include <mutex>
#include <stdexcept>

#include <fnmatch.h>

#include <fairlight/render/instruction_sets.h>
#include <fairlight/render/nearest_names.h>
#include <fairlight/validation/claims/claims.h>
#include <fairlight/validation/run/registry.h>

#if defined(FAIRLIGHT_WIDE_CLAIMS)
extern "C" {
void fairlight_packet_claims_avx2(std::vector<fairlight::Claim>&);
void fairlight_packet_claims_avx512(std::vector<fairlight::Claim>&);
}
#endif

namespace fairlight {
namespace {

std::vector<InstructionSet> claimed_sets() {
#if defined(FAIRLIGHT_WIDE_CLAIMS)
  return instruction_sets();
#else
  return {instruction_sets().front()};
#endif
}

void add_claims_by(const std::string& instructions, std::vector<Claim>& claims) {
#if defined(FAIRLIGHT_WIDE_CLAIMS)
  if (instructions == "avx2") return fairlight_packet_claims_avx2(claims);
  if (instructions == "avx512") return fairlight_packet_claims_avx512(claims);
#endif
  static_cast<void>(instructions);
  add_claims(claims);
}

std::vector<Claim> build(const std::string& instructions) {
  std::vector<Claim> claims;
  add_claims_by(instructions, claims);
  for (Claim& claim : claims) claim.instructions = instructions;
  return claims;
}

bool matches(const std::string& pattern, const std::string& name) {
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0 || name.starts_with(pattern + ".");
}

// The patterns without a wildcard that name claims: whole names, and their first dotted parts.
std::vector<std::string> patterns_of(const std::vector<Claim>& claims) {
  std::vector<std::string> patterns;
  for (const Claim& claim : claims) {
    for (std::size_t dot = claim.name.find('.'); dot != std::string::npos; dot = claim.name.find('.', dot + 1))
      patterns.push_back(claim.name.substr(0, dot));
    patterns.push_back(claim.name);
  }
  return patterns;
}

}  // namespace

std::vector<std::string> claimed_instructions() {
  std::vector<std::string> names;
  for (const InstructionSet& set : claimed_sets()) {
    if (set.runs_here) names.push_back(set.name);
  }
  return names;
}

const std::vector<Claim>& registry(const std::string& instructions) {
  static std::mutex mutex;
  static std::map<std::string, std::vector<Claim>> registries;
  const std::string set = choose_instructions(instructions, claimed_sets()).name;
  const std::lock_guard lock(mutex);
  if (!registries.contains(set)) registries.emplace(set, build(set));
  return registries.at(set);
}

std::vector<const Claim*> select_claims(const std::vector<std::string>& patterns, const std::string& instructions) {
  const std::vector<Claim>& all = registry(instructions);
  std::vector<bool> chosen(all.size(), patterns.empty());
  for (const std::string& pattern : patterns) {
    bool found = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!matches(pattern, all[i].name)) continue;
      chosen[i] = found = true;
    }
    if (found) continue;
    throw std::invalid_argument("no claim matches \"" + pattern + "\" " +
                                did_you_mean(pattern, patterns_of(all), "fairlight verify --list"));
  }
  std::vector<const Claim*> claims;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (chosen[i]) claims.push_back(&all[i]);
  }
  return claims;
}

}  // namespace fairlight
