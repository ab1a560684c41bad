#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace fairlight::testing {

/// What breaks the rules of the house under `root`, a sentence each; none when it is in order.

/// Includes may point down the chain stats <- estimators <- render <- validation <- tests, never up.
std::vector<std::string> includes_up_the_chain(const std::filesystem::path& root);

/// Headers of stats/ may use the standard library, Eigen, Boost.Math and each other; those that adapt a test
/// framework, that framework as well.
std::vector<std::string> foreign_includes_in_stats(const std::filesystem::path& root);

/// Every component must open with Source, and with Formula, Measure, Domain and Random when it has
/// a density; have a row in the registry, a test file of its header's name, and a section in
/// docs/estimators.md. Whatever a header of estimators/ declares outside namespaces called detail
/// is one, class or function, unless non_components.h says why not; so is a class of render/ that
/// samples, sums, plays, estimates, or has a section.
std::vector<std::string> components_without_papers(const std::filesystem::path& root,
                                                   const std::set<std::string>& registered);

/// Every section of docs/estimators.md is about components that are found.
std::vector<std::string> sections_without_component(const std::filesystem::path& root);

/// What non_components.h names exists, and has no row in the registry.
std::vector<std::string> stale_non_components(const std::filesystem::path& root,
                                              const std::set<std::string>& registered);

/// Every line of the table of bad input, the last part of docs/estimators.md, names tests that exist, as `Suite.Test`.
std::vector<std::string> missing_tests_of_bad_input(const std::filesystem::path& root);

}  // namespace fairlight::testing
