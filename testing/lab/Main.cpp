// SPDX-License-Identifier: GPL-3.0-or-later
// palpate-lab: experiments with ground truth. Exit code 0: every verdict passed; 1: one failed; 2: bad input.
#include <iostream>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "testing/lab/Runner.h"

namespace
{

using namespace palpate::lab;

struct Options
{
  bool json = false;
  std::vector<std::string> names;
  std::string folder;
  bool quick = false;
  bool soak = false;
  std::uint64_t seed = 1;
};

void list(bool json)
{
  nlohmann::json all = nlohmann::json::array();
  for (const Experiment& e : experiments())
  {
    if (json)
    {
      all.push_back({ { "name", e.name }, { "shows", e.shows }, { "rows", e.rows } });
      continue;
    }
    std::cout << e.name << std::string(e.name.size() < 20 ? 20 - e.name.size() : 1, ' ') << e.shows << "\n";
  }
  if (json)
  {
    std::cout << all.dump(2) << "\n";
  }
}

/// Prints the failures and, last, how many verdicts passed.
int report(const Score& score)
{
  for (const std::string& failure : score.failures)
  {
    std::cout << "fail: " << failure << "\n";
  }
  std::cout << score.passed << " of " << score.judged << " verdicts passed";
  if (score.absent > 0)
  {
    std::cout << ", " << score.absent << " absent";
  }
  std::cout << std::endl;
  return score.failures.empty() ? 0 : 1;
}

int runChosen(const Options& options)
{
  const std::vector<Experiment> chosen = choose(options.names);
  Conditions conditions;
  conditions.size = options.quick ? Size::Quick : options.soak ? Size::Soak : Size::Default;
  conditions.seed = options.seed;
  if (!options.soak)
  {
    return report(run(chosen, conditions, options.folder, std::cerr));
  }
  for (;; ++conditions.seed)
  {
    std::cout << "seed " << conditions.seed << "\n";
    const int code = report(run(chosen, conditions, options.folder, std::cerr));
    if (code != 0)
    {
      return code;
    }
  }
}

} // namespace

int main(int argc, char** argv)
{
  Options options;
  CLI::App app("Experiments with ground truth, on simulated devices in virtual time.", "palpate-lab");
  app.require_subcommand(1);
  CLI::App* const listCommand = app.add_subcommand("list", "what there is, and what each experiment shows");
  listCommand->add_flag("--json", options.json, "as JSON: name, shows, rows");
  CLI::App* const runCommand =
    app.add_subcommand("run", "run experiments, one CSV each; exit code 1 if a verdict fails");
  runCommand->add_option("NAME", options.names, "experiments, or all")->required();
  runCommand->add_option("--out", options.folder, "folder for the CSVs, made where it is missing")->required();
  CLI::Option* const quick = runCommand->add_flag("--quick", options.quick, "about a minute for all");
  runCommand
    ->add_flag("--soak", options.soak, "again and again with the next seed, until a verdict fails or it is stopped")
    ->excludes(quick);
  runCommand->add_option("--seed", options.seed, "for what is random (default 1)");
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try
  {
    if (listCommand->parsed())
    {
      list(options.json);
      return 0;
    }
    return runChosen(options);
  }
  catch (const std::exception& error)
  {
    std::cerr << "palpate-lab: " << error.what() << std::endl;
    return 2;
  }
}
