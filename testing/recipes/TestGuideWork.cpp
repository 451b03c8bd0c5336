// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "testing/lab/Experiment.h"

namespace palpate::lab
{

void runGuideWork(const Conditions& conditions, Table& table); // of docs/recipes/add-an-experiment.md

namespace
{

TEST(RecipeOfAnExperiment, PassesEachOfItsRows)
{
  Conditions conditions;
  conditions.size = Size::Quick;
  Table table("guide-work");
  runGuideWork(conditions, table);
  ASSERT_EQ(table.rows().size(), 3U);
  for (const Row& row : table.rows())
  {
    EXPECT_EQ(row.verdict, Verdict::Pass) << row.subject.caseName;
  }
}

} // namespace
} // namespace palpate::lab
