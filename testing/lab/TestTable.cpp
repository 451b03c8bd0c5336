// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <sstream>

#include <gtest/gtest.h>

#include "testing/lab/Runner.h"
#include "testing/support/TemporaryFolder.h"

namespace palpate::lab
{
namespace
{

TEST(Table, JudgesByToleranceByLimitAndByLeast)
{
  Table table("t");
  const Subject s{ "case", "method", "quantity", "N" };
  EXPECT_EQ(table.within(s, 1.02, 1.0, 0.021).verdict, Verdict::Pass);
  EXPECT_EQ(table.within(s, 0.97, 1.0, 0.02).verdict, Verdict::Fail);
  EXPECT_EQ(table.atMost(s, 0.05, 0.05).verdict, Verdict::Pass);
  EXPECT_EQ(table.atMost(s, 0.051, 0.05).verdict, Verdict::Fail);
  EXPECT_EQ(table.atLeast(s, 2.0, 2.0).verdict, Verdict::Pass);
  EXPECT_EQ(table.atLeast(s, 1.9, 2.0).verdict, Verdict::Fail);
  EXPECT_EQ(table.info(s, 3.0).verdict, Verdict::Info);
  EXPECT_EQ(table.absent(s).verdict, Verdict::Absent);
}

TEST(Table, RefusesAValueThatIsNotFinite)
{
  Table table("t");
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    EXPECT_THROW(table.info({ "c", "m", "q" }, bad), std::domain_error);
    EXPECT_THROW(table.within({ "c", "m", "q" }, 1.0, bad, 0.1), std::domain_error);
  }
  EXPECT_TRUE(table.rows().empty());
}

TEST(Table, WritesNumbersThatComeBackExactlyAndQuotesWhatNeedsIt)
{
  Table table("t");
  const double third = 1.0 / 3.0;
  table.within({ "a,b", "say \"m\"", "q", "" }, third, 0.1, 1.0).cost = Cost{ 0.5, 2.25, 4.5 };
  const std::string csv = toCsv(table);
  const std::string line = csv.substr(csv.find('\n') + 1);
  EXPECT_EQ(csv.substr(0, csv.find('\n')), csvHeader);
  EXPECT_EQ(line, "t,\"a,b\",\"say \"\"m\"\"\",q,0.3333333333333333,,0.1,1,pass,0.5,2.25,4.5\n");
  EXPECT_EQ(std::stod("0.3333333333333333"), third);
}

TEST(Table, NamesACaseByItsPairs)
{
  EXPECT_EQ(caseName({ { "rate", 1000.0 }, { "step", 5e-05 } }), "rate=1000 step=5e-05");
}

TEST(Runner, AnExperimentThatThrowsIsOneFailureAndTheOthersGoOn)
{
  const test::TemporaryFolder folder;
  const std::vector<Experiment> chosen = {
    { "throws", "", { 1 }, [](const Conditions&, Table&) { throw std::domain_error("a number that is none"); } },
    { "passes", "", { 1 },
      [](const Conditions& c, Table& t) {
        c.progress(1.0), t.atMost({ "c", "m", "q" }, 0.0, 1.0);
      } },
    { "fails", "", { 1 },
      [](const Conditions&, Table& t) {
        t.within({ "c", "m", "q" }, 2.0, 1.0, 0.5);
      } },
  };
  std::ostringstream log;
  const Score score = run(chosen, {}, folder.path(), log);
  EXPECT_EQ(score.passed, 1);
  EXPECT_EQ(score.judged, 3);
  ASSERT_EQ(score.failures.size(), 2u);
  EXPECT_NE(score.failures[0].find("a number that is none"), std::string::npos);
  EXPECT_NE(score.failures[1].find("fails, c, m: q is 2"), std::string::npos);
}

TEST(Runner, ChoosesInTheOrderOfTheListWhateverTheOrderOfNames)
{
  const auto all = choose({ "all" });
  ASSERT_GE(all.size(), 2u);
  const auto two = choose({ all[1].name, all[0].name });
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0].name, all[0].name);
  EXPECT_THROW(static_cast<void>(choose({ "nothing of the kind" })), std::invalid_argument);
}

} // namespace
} // namespace palpate::lab
