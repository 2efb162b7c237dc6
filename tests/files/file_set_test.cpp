// SPDX-License-Identifier: GPL-3.0-or-later
// Contract: after commit() all files are new; after a failure at any of them, or without commit(), all are as
// they were, and no other file is left.
#include "files/file_set.hpp"

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "files/file_error.hpp"
#include "support/temporary_folder.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

using Contents = std::map<std::string, std::string>;

// Of all that is in the folder; folders are marked.
Contents contents(const fs::path& folder) {
  Contents found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    std::ostringstream text;
    if (entry.is_regular_file()) text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    found[entry.path().filename().string()] = entry.is_regular_file() ? text.str() : "<folder>";
  }
  return found;
}

TEST(FileSet, NewAndOldFilesAreReplacedAtCommit) {
  const TemporaryFolder folder;
  folder.write("b", "old b");
  FileSet set;
  set.add(folder.path() / "a", "new a");
  set.add(folder.path() / "b", "new b");
  EXPECT_FALSE(fs::exists(folder.path() / "a"));
  set.commit();
  EXPECT_EQ(contents(folder.path()), (Contents{{"a", "new a"}, {"b", "new b"}}));
  set.commit();  // empty now
  set.add(folder.path() / "a", "newer a");
  set.commit();
  EXPECT_EQ(contents(folder.path()), (Contents{{"a", "newer a"}, {"b", "new b"}}));
}

TEST(FileSet, WithoutCommitNothingChanges) {
  const TemporaryFolder folder;
  folder.write("b", "old b");
  {
    FileSet set;
    set.add(folder.path() / "a", "new a");
    set.add(folder.path() / "b", "new b");
  }
  EXPECT_EQ(contents(folder.path()), (Contents{{"b", "old b"}}));
}

// A folder that appears in the place of file k between add() and commit() lets its renaming fail.
TEST(FileSet, AFailureAtAnyFileTakesBackThoseBeforeIt) {
  for (int failing = 0; failing < 4; ++failing) {
    const TemporaryFolder folder;
    folder.write("0", "old 0");
    folder.write("2", "old 2");
    FileSet set;
    for (int k = 0; k < 4; ++k) set.add(folder.path() / std::to_string(k), "new " + std::to_string(k));
    const fs::path taken = folder.path() / std::to_string(failing);
    fs::remove(taken);
    fs::create_directory(taken);
    const Contents before{{"0", failing == 0 ? "<folder>" : "old 0"},
                          {"2", failing == 2 ? "<folder>" : "old 2"}};
    Contents expected = before;
    expected[std::to_string(failing)] = "<folder>";
    EXPECT_THROW(set.commit(), FileError);
    EXPECT_EQ(contents(folder.path()), expected) << failing;
  }
}

TEST(FileSet, AFileOfTheSameBytesKeepsItsTimeStamp) {
  const TemporaryFolder folder;
  const fs::path same = folder.write("same", "bytes");
  const auto long_ago = fs::last_write_time(same) - std::chrono::hours(24);
  fs::last_write_time(same, long_ago);
  FileSet set;
  set.add(same, "bytes");
  set.add(folder.path() / "other", "bytes");
  set.commit();
  EXPECT_EQ(fs::last_write_time(same), long_ago);
  EXPECT_EQ(contents(folder.path()), (Contents{{"same", "bytes"}, {"other", "bytes"}}));
}

TEST(FileSet, ALinkIsReplacedAndNotFollowed) {
  const TemporaryFolder folder;
  folder.write("far", "old");
  fs::create_symlink("far", folder.path() / "near");
  fs::create_symlink("loop", folder.path() / "loop");
  FileSet set;
  set.add(folder.path() / "near", "new");
  set.add(folder.path() / "loop", "new");
  set.commit();
  EXPECT_EQ(contents(folder.path()), (Contents{{"far", "old"}, {"near", "new"}, {"loop", "new"}}));
}

TEST(FileSet, FoldersAreRefusedByName) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "taken");
  FileSet set;
  for (const char* name : {"taken", "none/file"}) {
    const std::string said = test::thrown<FileError>([&] { set.add(folder.path() / name, "bytes"); });
    EXPECT_TRUE(said.starts_with((folder.path() / name).string() + ": ")) << said;
  }
}

}  // namespace
}  // namespace impinge
