// SPDX-License-Identifier: GPL-3.0-or-later
#include "harness/source_state.hpp"

#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

#include "support/temporary_folder.hpp"

namespace impinge::lab {
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

// A repository with one file, "kept", committed.
void commit_one_file(const std::filesystem::path& folder) {
  ASSERT_EQ(git_in(folder, "init"), 0);
  std::ofstream(folder / "kept") << "as committed";
  std::ofstream(folder / ".gitignore") << "*.tmp\n";
  ASSERT_EQ(git_in(folder, "add kept .gitignore"), 0);
  ASSERT_EQ(git_in(folder, "-c user.name=t -c user.email=t@t commit -m first"), 0);
}

TEST(SourceState, TellsACleanTreeFromAChangedOne) {
  const TemporaryFolder folder;
  commit_one_file(folder.path());
  const SourceState clean = source_state(folder.path());
  EXPECT_EQ(clean.commit.size(), 40U);
  EXPECT_EQ(clean.dirty, false);
  std::ofstream(folder.path() / "kept") << "changed";
  EXPECT_EQ(source_state(folder.path()).dirty, true);
  EXPECT_EQ(source_state(folder.path()).commit, clean.commit);
}

TEST(SourceState, CountsNewFilesWhereResultsComeFrom) {
  for (const char* name : {"libcore", "experiments", "analysis", "paper"}) {
    const TemporaryFolder folder;
    commit_one_file(folder.path());
    std::filesystem::create_directories(folder.path() / name / "inner");
    std::ofstream(folder.path() / name / "inner" / "ignored.tmp") << "x";
    std::ofstream(folder.path() / "note.txt") << "x";
    EXPECT_EQ(source_state(folder.path()).dirty, false) << name;
    std::ofstream(folder.path() / name / "inner" / "new file.cpp") << "x";
    EXPECT_EQ(source_state(folder.path()).dirty, true) << name;
  }
}

}  // namespace
}  // namespace impinge::lab
