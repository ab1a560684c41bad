#include <algorithm>
#include <array>
#include <stdexcept>

#include <fairlight/render/nearest_names.h>
#include <fairlight/stats/text.h>
#include <fairlight/validation/studies/all_studies.h>

namespace fairlight {
namespace {

namespace run = studies_of_paper;

constexpr std::array all{
    Study{"fig1", "Importance sampling of a BRDF", "the paper, 3.1 and Fig. 1", 15, run::fig1},
    Study{"fig2", "Implicit against explicit light sampling", "the paper, 3.2 and Fig. 2", 240, run::fig2},
    Study{"fig3", "Fixed depth against Russian roulette", "the paper, 3.2.1 and Fig. 3", 60, run::fig3},
    Study{"fig4", "Where the variance lies", "the paper, 3.2.2 and Fig. 4", 120, run::fig4},
    Study{"fig5", "Apertures and fields of view", "the paper, 3.2.3 and Fig. 5", 20, run::fig5},
    Study{"fig6", "A hallway through a wide lens", "the paper, 3.2.3 and Fig. 6", 30, run::fig6},
    Study{"fig7", "A hallway through a narrow lens", "the paper, 3.2.3 and Fig. 7", 30, run::fig7},
    Study{"a1", "One of many lights against all", "the paper, A.1", 90, run::a1},
    Study{"a2", "Light that is counted twice", "the paper, A.2", 30, run::a2},
    Study{"cost", "Error against time", "the paper, 2 and 3.2", 180, run::cost},
    Study{"montelight", "The biases of the paper's own renderer", "Smerity/montelight-cpp", 90, run::montelight},
};

}  // namespace

std::span<const Study> studies() { return all; }

const Study& study_named(const std::string& name) {
  const auto found = std::ranges::find(all, name, &Study::name);
  if (found != all.end()) return *found;
  std::vector<std::string> names{"all"};
  std::string listed = "all";
  for (const Study& study : all) {
    names.emplace_back(study.name);
    listed.append(", ").append(study.name);
  }
  throw std::invalid_argument(formatted("there is no study \"%s\" among %s %s", name.c_str(), listed.c_str(),
                                        did_you_mean(name, names, "fairlight study --help").c_str()));
}

}  // namespace fairlight
