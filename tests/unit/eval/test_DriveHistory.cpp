#include <gtest/gtest.h>
#include <mrpt_mapconv/eval/DriveHistory.h>

#include "HandMadeScans.h"

// What a cell has been through, and which cells the experiment counts as traces of people.

namespace mrpt_mapconv
{
namespace
{
using namespace fixtures;

constexpr std::int32_t kPlace = 10;  // where a person is seen
const std::vector<Return> kPerson = {{kPlace, "person.anna"}};
const std::vector<Return> kCrate = {{kPlace, "box.crate"}};
const std::vector<Return> kFreeBefore = {{20, "box.crate"}};  // so kPlace is free

class History
{
 public:
  void add(const std::vector<Return>& returns, int times = 1)
  {
    const eval::PosedScan scan = scanFrom(0, returns);
    for (int i = 0; i < times; ++i) m_history.add(seenBy(returns), scan, profileOf(scan));
  }

  eval::CellHistory at(std::int32_t x) const { return cellOf(m_history.cells(), x); }

  /** On a map that has some cells as occupied at the end. */
  eval::PeopleTraces traces(const std::vector<std::int32_t>& occupied = {kPlace},
                            const std::vector<std::int32_t>& trulyOccupied = {20}) const
  {
    return eval::peopleTraces(layerWith(occupied, 1.0f, grid::kFree), truthWith(trulyOccupied),
                              m_history.cells());
  }

 private:
  eval::DriveHistory m_history{kFrame, world(), uncut()};
};
}  // namespace

TEST(DriveHistory, APersonMustHaveFadedAfterTenScansThatSayFree)
{
  History history;
  history.add(kPerson);
  for (int frees = 1; frees <= 11; ++frees)
  {
    history.add(kFreeBefore);
    EXPECT_EQ(frees, history.at(kPlace).freeSincePerson);
    const eval::PeopleTraces traces = history.traces();
    EXPECT_EQ(1u, traces.hitByPerson) << frees;
    EXPECT_EQ(frees >= 10 ? 1u : 0u, traces.notFaded) << frees;
    EXPECT_EQ(0u, traces.hitByOthers) << frees;
  }
}

TEST(DriveHistory, AnotherPersonStartsTheCountAgain)
{
  History history;
  history.add(kPerson);
  history.add(kFreeBefore, 10);
  EXPECT_EQ(1u, history.traces().notFaded);
  history.add(kPerson);
  EXPECT_EQ(0, history.at(kPlace).freeSincePerson);
  EXPECT_EQ(0u, history.traces().notFaded);
  history.add(kFreeBefore, 9);
  EXPECT_EQ(0u, history.traces().notFaded);
  history.add(kFreeBefore);
  EXPECT_EQ(1u, history.traces().notFaded);
}

TEST(DriveHistory, WhatSomethingElseHasHitSinceIsNoTraceOfAPerson)
{
  History history;
  history.add(kPerson);
  history.add(kFreeBefore, 9);
  history.add(kCrate);
  EXPECT_FALSE(history.at(kPlace).hitByPerson);
  EXPECT_EQ(0u, history.traces().hitByPerson);
  EXPECT_EQ(0u, history.traces().hitByOthers) << "free only nine times since the person";
  history.add(kFreeBefore);  // which does not change what it was last hit by
  EXPECT_EQ(0u, history.traces().notFaded);
  EXPECT_EQ(1u, history.traces().hitByOthers);
  history.add(kPerson);
  EXPECT_EQ(1u, history.traces().hitByPerson);
  EXPECT_EQ(0u, history.traces().notFaded);
  EXPECT_EQ(0u, history.traces().hitByOthers);
}

TEST(DriveHistory, APersonAndSomethingElseInOneScanIsAPerson)
{
  History history;
  history.add({{kPlace, "person.anna"}, {kPlace, "box.crate"}});
  EXPECT_TRUE(history.at(kPlace).hitByPerson);
}

TEST(DriveHistory, ScansBeforeThePersonDoNotCount)
{
  History history;
  history.add(kFreeBefore, 30);
  EXPECT_EQ(0u, history.traces().seen);
  history.add(kPerson);
  EXPECT_EQ(0, history.at(kPlace).freeSincePerson);
  EXPECT_EQ(0u, history.traces().notFaded);
}

TEST(DriveHistory, TracesAreCountedStepByStep)
{
  History history;
  history.add({{9, "person.anna"}, {10, "person.anna"}, {11, "person.anna"}});
  history.add(kFreeBefore, 10);
  const eval::PeopleTraces traces = history.traces({9, 10, 15}, {10});  // nobody was in cell 15
  EXPECT_EQ(3u, traces.seen);
  EXPECT_EQ(2u, traces.freeInTruth);
  EXPECT_EQ(1u, traces.occupied);
  EXPECT_EQ(1u, traces.hitByPerson);
  EXPECT_EQ(1u, traces.notFaded);
  eval::PeopleTraces twice = traces;
  twice += traces;
  EXPECT_EQ(6u, twice.seen);
  EXPECT_EQ(4u, twice.freeInTruth);
  EXPECT_EQ(2u, twice.notFaded);
}

TEST(DriveHistory, OnlyReturnsThatTheProfileCanHaveCount)
{
  History history;
  history.add({{kPlace, "person.anna", false, 1.6}, {kPlace, "person.anna", false, 0.02}});
  EXPECT_FALSE(history.at(kPlace).person) << "above and below the object slice";
  history.add({{2, "person.anna"}, {26, "person.anna"}});
  EXPECT_FALSE(history.at(2).person) << "nearer than minRange";
  EXPECT_FALSE(history.at(26).person) << "beyond maxRange";
  EXPECT_EQ(0u, history.traces().seen);
}

TEST(DriveHistory, GhostsOfPeopleAreTracesToo)
{
  History history;
  history.add({{kPlace, "person.anna", true}, {12, "box.crate"}, {14, "box.crate", true}});
  EXPECT_TRUE(history.at(kPlace).hitByPerson);
  EXPECT_TRUE(history.at(kPlace).ghost);
  EXPECT_FALSE(history.at(kPlace).real);
  EXPECT_TRUE(history.at(12).real);
  EXPECT_FALSE(history.at(12).ghost);
  const auto map = layerWith({kPlace, 12, 14, 16, 20}, 1.0f, grid::kFree);
  eval::DriveHistory ghosts(kFrame, world(), uncut());
  const std::vector<Return> returns = {
      {10, "box.crate", true}, {12}, {14, "box.crate", true}, {14}};
  ghosts.add(seenBy(returns), scanFrom(0, returns), profileOf(returns));
  const eval::FalseObstacles found = eval::falseObstacles(map, truthWith({20}), ghosts.cells());
  EXPECT_EQ(4u, found.cells);
  EXPECT_EQ(1u, found.onlyGhosts);
}

}  // namespace mrpt_mapconv
