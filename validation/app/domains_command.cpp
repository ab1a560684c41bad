#include <algorithm>
#include <cstdio>
#include <map>

#include <fairlight/stats/text.h>
#include <fairlight/validation/app/commands.h>
#include <fairlight/validation/app/options.h>
#include <fairlight/validation/checks/parameters.h>
#include <fairlight/validation/run/registry.h>

namespace fairlight {
namespace {

std::string interval(double low, double high) { return formatted("%g to %g", low, high); }

// Prints a table in Markdown. The exit status is 1 if claims do not reach an end of a domain and
// the table of domains does not say why.
int domains() {
  std::map<std::pair<std::string, std::string>, std::pair<double, double>> reached;
  for (const Claim& claim : registry()) {
    for (const ParameterRange& range : claim.covers) {
      const auto [place, is_new] = reached.try_emplace({range.component, range.parameter}, range.low, range.high);
      if (is_new) continue;
      auto& [low, high] = place->second;
      low = std::min(low, range.low);
      high = std::max(high, range.high);
    }
  }
  bool explained = true;
  std::printf(
      "| component | parameter | unit | domain | claims reach | reason for a gap |\n|---|---|---|---|---|---|\n");
  for (const ParameterDomain& d : parameter_domains()) {
    const auto found = reached.find({d.component, d.parameter});
    const bool any = found != reached.end();
    const bool whole = any && found->second.first <= d.low && found->second.second >= d.high;
    explained = explained && whole == d.gap.empty();
    std::printf("| `%s` | %s | %s | %s | %s | %s |\n", d.component.c_str(), d.parameter.c_str(), d.unit.c_str(),
                interval(d.low, d.high).c_str(),
                any ? interval(found->second.first, found->second.second).c_str() : "nothing", d.gap.c_str());
  }
  return explained ? 0 : 1;
}

}  // namespace

void add_domains_command(CLI::App& audit, Command& command) {
  auto* app = audit.add_subcommand(
      "domains",
      "Print, for each parameter, the domain that its component states and the range that claims draw from.");
  add_examples(*app, {"fairlight audit domains"});
  app->callback([&command] { command = [] { return domains(); }; });
}

}  // namespace fairlight
