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

/// Every component in estimators/ and render/, a class that samples, sums, plays or estimates, must open with Source, and with
/// Formula, Measure, Domain and Random when it has a density; have a row in the registry, a test file of its
/// header's name, and a section in docs/estimators.md. What only looks up one of them while the program runs, Chosen..., is none.
std::vector<std::string> components_without_papers(const std::filesystem::path& root,
                                                   const std::set<std::string>& registered);

/// Every line of the table of bad input, the last part of docs/estimators.md, names tests that exist, as `Suite.Test`.
std::vector<std::string> missing_tests_of_bad_input(const std::filesystem::path& root);

}  // namespace fairlight::testing
