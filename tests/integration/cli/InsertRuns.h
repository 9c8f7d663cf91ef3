#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "Program.h"
#include "ScanFiles.h"
#include "support/TempDir.h"

/** What the tests of mapconv insert share. */
namespace mrpt_mapconv::testing
{
/** A scan of one point, 1.5 m ahead. */
inline mrpt::obs::CObservation::Ptr chair(double seconds)
{
  return cloudOn({{1.75f, 0.25f, 0.5f}}, {0.25, 0.25, 1}, seconds);
}

/** Expects one error, with these words in it. */
inline void expectWords(const Outcome& run, const std::vector<std::string>& words)
{
  EXPECT_EQ("", run.out);
  EXPECT_TRUE(isOneError(run.err)) << run.err;
  for (const auto& word : words) EXPECT_TRUE(contains(run.err, word)) << word << " in " << run.err;
}

}  // namespace mrpt_mapconv::testing
