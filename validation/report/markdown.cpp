#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fairlight/stats/seed.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/report/markdown.h>
#include <fairlight/validation/report/report.h>
#include <fairlight/version.h>

namespace fairlight {
namespace {

namespace fs = std::filesystem;

std::string link(const std::string& picture, const std::string& page) {
  const fs::path base = fs::absolute(page).parent_path();
  return fs::absolute(picture).lexically_normal().lexically_relative(base.lexically_normal()).generic_string();
}

std::string code(const std::string& command) { return "```\n" + command + "\n```\n\n"; }

std::string head(const Page& page) {
  const auto& terms = page.run_options.terms;
  const auto count = [&](Verdict verdict) {
    return std::ranges::count_if(page.outcomes, [=](const Outcome& o) { return o.finding.verdict == verdict; });
  };
  std::string out = std::string("# fairlight verify: ") + name(overall(page.outcomes, page.components)) + "\n\n";
  out += formatted("Of %zu claims, %td are certified, %td biased, %td undecided.\n\n", page.outcomes.size(),
                   count(Verdict::certified), count(Verdict::biased), count(Verdict::undecided));
  out += "| | |\n|---|---|\n";
  out += "| seed | `" + seed_text(terms.seed) + "` |\n";
  out += formatted("| false alarms | %.0e a run of everything |\n", terms.budget);
  out += formatted("| miss rate | %.0e a claim, at its margin |\n", terms.beta);
  out += formatted("| margin | %.0e of the reference, times what a claim says |\n", terms.margin);
  out += formatted("| time | %.1f s on %d threads |\n", page.seconds, page.run_options.threads);
  out += "| instructions of packets | " + instruction_list(page.outcomes) + " |\n";
  out += formatted("| version | %s |\n\n", version);
  return out + "To run it again, draw for draw:\n\n" + code(page.command);
}

std::string in_words(const Interval& bias) {
  const std::string lo = end_text(bias.lo), hi = end_text(bias.hi);
  if (std::isinf(bias.lo) && std::isinf(bias.hi)) return "not known yet";
  if (std::isinf(bias.lo)) return "at most " + hi;
  if (std::isinf(bias.hi)) return "at least " + lo;
  return "between " + lo + " and " + hi;
}

std::string section(const Page& page, const Outcome& outcome, const std::string& path) {
  const Finding& finding = outcome.finding;
  const std::string title = label(outcome, page.run_options);
  std::string out = "## " + title + ": " + name(finding.verdict) + "\n\n";
  out += "Claimed (" + outcome.claim->kind + "): " + outcome.claim->statement +
         ". Source: " + outcome.claim->source + ".\n\n";
  out += "The bias, relative to the reference, is " + in_words(finding.interval);
  out += formatted(", the margin %.1e; %llu draws in %.2f s.", finding.margin,
                   static_cast<unsigned long long>(finding.draws), outcome.seconds);
  out += (finding.note.empty() ? "" : " Note: " + finding.note + ".") + "\n\n" +
         code(replay(*outcome.claim, page.run_options));
  const auto pictures = page.pictures.find(title);
  if (pictures == page.pictures.end()) return out;
  for (const std::string& picture : pictures->second) {
    out += "![" + fs::path(picture).stem().string() + " of " + title + "](" + link(picture, path) + ")\n\n";
  }
  return out;
}

std::string table(const std::vector<Outcome>& outcomes, const RunOptions& run_options) {
  std::string out = "| claim | verdict | guarantee | margin | bias between | and | draws | seconds |\n";
  out += "|---|---|---|--:|--:|--:|--:|--:|\n";
  for (const Outcome& outcome : outcomes) {
    const Finding& finding = outcome.finding;
    out += "| " + label(outcome, run_options) + " | " + name(finding.verdict) + " | " + name(finding.guarantee);
    out += formatted(" | %.1e | %s | %s | %llu | %.2f |\n", finding.margin, end_text(finding.interval.lo).c_str(),
                     end_text(finding.interval.hi).c_str(), static_cast<unsigned long long>(finding.draws),
                     outcome.seconds);
  }
  return out;
}

std::string table_of(const std::vector<ComponentOutcome>& components) {
  if (components.empty()) return "";
  std::string out = "\n## Components\n\n";
  out += "A relative bias that is common to the claims of a component, at the same miss rate.\n\n";
  out += "| component | instructions | claims | verdict | common bias |\n|---|---|--:|---|---|\n";
  for (const ComponentOutcome& c : components)
    out += formatted("| %s | %s | %zu | %s | %s |\n", c.name.c_str(), c.instructions.c_str(), c.claims,
                     name(c.verdict), common_bias_text(c).c_str());
  return out;
}

}  // namespace

std::string markdown(const Page& page, const std::string& path) {
  const std::vector<Outcome> sorted = worst_first(page.outcomes);
  std::string out = head(page);
  if (!page.overview.empty()) {
    out += "![the intervals of all claims, in units of their margins](" + link(page.overview, path) + ")\n\n";
  }
  for (const Outcome& outcome : sorted) {
    if (failed(outcome) || page.pictures.contains(label(outcome, page.run_options)))
      out += section(page, outcome, path);
  }
  return out + "## All claims\n\n" + table(sorted, page.run_options) + table_of(page.components);
}

}  // namespace fairlight
