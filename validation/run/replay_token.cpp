#include <stdexcept>

#include <fairlight/source_digits.h>
#include <fairlight/stats/seed.h>
#include <fairlight/validation/run/replay_token.h>

namespace fairlight {

std::string replay_token(std::uint64_t seed) { return seed_text(seed) + "-" + source_digits; }

std::uint64_t parse_replay_token(const std::string& text) {
  const std::size_t hyphen = text.find('-');
  if (hyphen == std::string::npos) return parse_seed(text);
  const std::string digits = text.substr(0, hyphen);
  const std::string sources = text.substr(hyphen + 1);
  if (digits.size() != 16 || sources.size() != 8 ||
      sources.find_first_not_of("0123456789abcdef") != std::string::npos) {
    throw std::invalid_argument(
        "\"" + text +
        "\" is no token of a run (give all of what it printed, or a seed of 1 to 16 hexadecimal digits)");
  }
  const std::uint64_t seed = parse_seed(digits);
  if (sources == source_digits) return seed;
  throw std::invalid_argument("\"" + text + "\" is a token of other sources than this program's, which are " +
                              source_digits + " (build those, or give \"" + digits +
                              "\" to run these sources with its numbers)");
}

}  // namespace fairlight
