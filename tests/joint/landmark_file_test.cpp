// SPDX-License-Identifier: GPL-3.0-or-later
// Points of one person as each program writes them: the right ASIS lies at 120 mm right, 40 anterior, 7
// superior.
#include "joint/landmark_file.hpp"

#include <string>

#include <gtest/gtest.h>

#include "files/file_error.hpp"
#include "support/temporary_folder.hpp"
#include "support/thrown.hpp"

namespace impinge {
namespace {

class LandmarkFile : public testing::Test {
 protected:
  Landmarks read(const std::string& name, const std::string& bytes, const char* meshes) {
    return read_landmarks(folder_.write(name, bytes), input_to_joint(meshes));
  }
  void expect_found(const std::string& name, const std::string& bytes) {
    for (const auto& [meshes, right_asis] : {std::pair("RAS", Vec3(120.0, 40.0, 7.5)),
                                             {"LPS", Vec3(-120.0, -40.0, 7.5)},
                                             {"ALS", Vec3(40.0, -120.0, 7.5)}}) {
      const Landmarks found = read(name, bytes, meshes);
      ASSERT_TRUE(found.asis_right.has_value()) << name << bytes;
      EXPECT_EQ(*found.asis_right, right_asis) << name << meshes << bytes;
      EXPECT_FALSE(found.asis_left.has_value()) << name;  // it is not placed
      EXPECT_FALSE(found.epicondyle_medial.has_value());
    }
  }
  std::string refused(const std::string& name, const std::string& bytes) {
    return test::thrown<FileError>([&] { read(name, bytes, "RAS"); });
  }

  test::TemporaryFolder folder_;
};

const std::string kColumns = "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n";

TEST_F(LandmarkFile, FiducialsAreInTheFrameThatTheyName) {
  const std::string ras = "vtkMRMLMarkupsFiducialNode_0,120,40,7.5,0,0,0,1,1,1,0,asis_right,,\n";
  const std::string lps = "1,-120,-40,7.5,0.000,0.000,0.000,1.000,1,1,0,\"ASIS, right\",\"so,so\",,2,0\n";
  const std::string unplaced = "2,0,0,0,0,0,0,1,1,1,0,asis_left,,,0,0\n";
  for (const char* system : {"0", "RAS"})
    expect_found("old.fcsv", "# Markups fiducial file version = 4.10\n# CoordinateSystem = " +
                                 std::string(system) + "\n" + kColumns + ras);
  for (const char* system : {"1", "LPS"})
    expect_found("new.FCSV", "# Markups fiducial file version = 5.0\r\n# CoordinateSystem = " +
                                 std::string(system) + "\r\n" + kColumns + lps + unplaced);
  expect_found("silent.fcsv", kColumns + ras);
  expect_found("slicer3.fcsv",
               "# Fiducial List file /a.fcsv\n# version = 2\n# columns = label,x,y,z,sel,vis\nright "
               "ASIS,120,40,7.5,1,1\n");
}

TEST_F(LandmarkFile, TablesOfSlicerAreInTheFrameOfTheirColumns) {
  const std::string rest = ",defined,selected,visible,locked,description\n";
  expect_found("ras.csv",
               "label,r,a,s" + rest + "asis_right,120,40,7.5,1,1,1,0,\nasis_left,0,0,0,0,1,1,0,\n");
  expect_found("lps.csv",
               "label,l,p,s" + rest +
                   "\"asis, right\",-120,-40,7.5,1,1,1,0,\"here, or so\"\nelsewhere,1,2,3,1,1,1,0,\n");
  expect_found("excel.csv", "\xEF\xBB\xBFLabel;R;A;S\r\nASIS right;120;40;7,5\r\n");
}

TEST_F(LandmarkFile, OtherTablesAreInTheFrameOfTheMeshes) {
  for (const char* meshes : {"RAS", "LPS"})
    EXPECT_EQ(read("own.csv", "x\ty\tz\tlabel\n1\t2\t3\tright asis\n", meshes).asis_right,
              Vec3(1.0, 2.0, 3.0));
}

TEST_F(LandmarkFile, WhatIsNoneSaysWhy) {
  for (const auto& [name, bytes, word] :
       {std::tuple("a.csv", "name,x,y,z\n", "line 1 does not name the columns label,x,y,z"),
        {"a.csv", "label,r,p,s\nasis_right,1,2,3\n", "line 1 does not name the columns"},
        {"a.csv", "label,r,a,s\n\nasis_right,1,here,3\n", "line 3 has 'here', which is no number"},
        {"a.csv", "label,r,a,s\nasis_right,1,2\n", "line 2 has 3 fields below 4 names"},
        {"a.csv", "label,x,y,z\nasis_right,1,2,3,4\n", "line 2 has 5 fields below 4 names"},
        {"a.csv", "label,r,a,s\nasis_right,1,2,3\nRight ASIS,1,2,3\n", "Right ASIS is there twice"},
        {"a.csv", "label,r,a,s\nF-1,1,2,3\nF-2,1,2,3\n",
         "its labels are of no landmark: F-1, F-2; call them asis_right"},
        {"a.fcsv", "# CoordinateSystem = IJK\n",
         "line 1 has a CoordinateSystem that is neither RAS (0) nor LPS (1)"},
        {"a.fcsv", "# columns = id,x,y\n", "line 1 does not name the columns"},
        {"a.fcsv", "asis_right,1\n", "line 1 has 2 fields below 6 names"},
        {"a.mrk.json", R"({"markups": [{"controlPoints": [{"label": "F-1", "position": [1, 2, 3]}]}]})",
         "its labels are of no landmark: F-1;"},
        {"a.mrk.json", R"({"markups": [)", "has no markups"},
        {"a.mrk.json", "[]", "has no markups"},
        {"a.mrk.json", R"({"markups": [{"coordinateSystem": "XYZ", "controlPoints": []}]})",
         "its coordinateSystem is neither LPS nor RAS"}}) {
    const std::string said = refused(name, bytes);
    EXPECT_NE(said.find(word), said.npos) << bytes << said;
    EXPECT_EQ(said.find('\n'), said.npos);
  }
}

}  // namespace
}  // namespace impinge
