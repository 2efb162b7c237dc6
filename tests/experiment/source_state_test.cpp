// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiment/source_state.hpp"

#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

#include "support/temporary_folder.hpp"

namespace impinge {
namespace {

using test::TemporaryFolder;

int git_in(const std::filesystem::path& folder, const std::string& arguments) {
  return std::system(("git -C '" + folder.string() + "' " + arguments + " >/dev/null 2>&1").c_str());
}

TEST(SourceState, IsUnknownOutsideOfARepository) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / ".git") << "not a repository";  // stops the search in the folders above
  const SourceState state = source_state(folder.path());
  EXPECT_EQ(state.commit, "unknown");
  EXPECT_FALSE(state.dirty.has_value());
}

TEST(SourceState, TellsACleanTreeFromADirtyOne) {
  const TemporaryFolder folder;
  ASSERT_EQ(git_in(folder.path(), "init"), 0);
  ASSERT_EQ(git_in(folder.path(), "-c user.name=t -c user.email=t@t commit --allow-empty -m first"), 0);
  const SourceState clean = source_state(folder.path());
  EXPECT_EQ(clean.commit.size(), 40U);
  EXPECT_EQ(clean.dirty, false);
  std::ofstream(folder.path() / "new file") << "x";
  EXPECT_EQ(source_state(folder.path()).dirty, true);
  EXPECT_EQ(source_state(folder.path()).commit, clean.commit);
}

}  // namespace
}  // namespace impinge
