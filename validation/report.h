#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <fairlight/validation/conformance.h>

namespace fairlight {

/// The command that runs one claim again, draw for draw.
std::string replay(const std::string& claim, const Conformance& conformance);

/// A table of claims, the worst verdict first, and how to replay those that failed.
void print_outcomes(std::FILE* out, const std::vector<Outcome>& outcomes, const Conformance& conformance);

/// The same as JSON: {version, seed, budget, seconds, verdict, claims: [...]}.
nlohmann::json outcomes_json(const std::vector<Outcome>& outcomes, const Conformance& conformance, double seconds);

}  // namespace fairlight
