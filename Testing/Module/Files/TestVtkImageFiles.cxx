// VTK's files of image data: cells, pieces, the legacy format, and the choice of the array.
#include "PhantomFiles.h"
#include "VolumeRead.h"

#include <gtest/gtest.h>

#include <vtkStructuredPointsWriter.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

namespace
{

std::string Replaced(std::string text, const std::string& from, const std::string& to)
{
  for (std::size_t place = text.find(from); place != std::string::npos;
       place = text.find(from, place + to.size()))
  {
    text.replace(place, from.size(), to);
  }
  return text;
}

/// An array of VTI with a number for each of 60 values and each component.
std::string ArrayText(const std::string& name, int componentCount, const std::string& number)
{
  std::string numbers;
  for (int i = 0; i < 60 * componentCount; ++i)
  {
    numbers += number + ' ';
  }
  return "<DataArray type=\"Float32\" Name=\"" + name + "\" NumberOfComponents=\"" +
    std::to_string(componentCount) + "\" format=\"ascii\">" + numbers + "</DataArray>\n";
}

class VtkImageFiles : public testing::Test
{
protected:
  TemporaryFolder folder;
  const StoredVolume volume = phantom::Stored(0);
};

TEST_F(VtkImageFiles, CellsAreVoxelsOfTheirOwnNumber)
{
  const VolumeRead read = ReadVolumeAt(this->folder.Write("a.vti", VtiCellText(this->volume)));
  EXPECT_EQ(read.values, this->volume.values) << read.error;
  EXPECT_EQ(read.warnings.find("The file does not say which side"), 0u) << read.warnings;
}

TEST_F(VtkImageFiles, TheActiveArrayAtPointsIsPreferred)
{
  const std::string begin = "<PointData Scalars=\"density\">\n";
  const std::string others =
    ArrayText("vtkGhostType", 1, "0") + ArrayText("tensor", 9, "2") + ArrayText("vector", 3, "1");
  const std::string text = VtiText(this->volume);
  EXPECT_EQ(ReadVolumeAt(this->folder.Write("a.vti", Replaced(text, begin, begin + others))).values,
    this->volume.values);
  const std::string inactive = Replaced(text, begin, "<PointData>\n" + others);
  const VolumeRead read = ReadVolumeAt(this->folder.Write("b.vti", inactive));
  EXPECT_EQ(read.componentCount, 3) << read.error;
}

TEST_F(VtkImageFiles, ATensorIsReadByItsMagnitude)
{
  const std::string begin = "<PointData Scalars=\"density\">\n";
  const std::string text = Replaced(
    VtiText(this->volume), begin, "<PointData Scalars=\"tensor\">\n" + ArrayText("tensor", 9, "2"));
  const VolumeRead read = ReadVolumeAt(this->folder.Write("a.vti", text));
  EXPECT_EQ(read.values, std::vector<double>(60, 6.0)) << read.error;
  EXPECT_TRUE(read.WarnsOf("9 components")) << read.warnings;
}

TEST_F(VtkImageFiles, LegacyFilesInTextAndBinary)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 4, 3);
  image->SetSpacing(0.7, 1.1, 2.5);
  image->SetOrigin(-10, -20, 30);
  image->AllocateScalars(VTK_SHORT, 1);
  for (int i = 0; i < 60; ++i)
  {
    image->GetPointData()->GetScalars()->SetTuple1(i, this->volume.values[std::size_t(i)]);
  }
  vtkNew<vtkStructuredPointsWriter> writer;
  writer->SetInputData(image);
  writer->WriteToOutputStringOn();
  for (const int type : { VTK_ASCII, VTK_BINARY })
  {
    writer->SetFileType(type);
    writer->Write();
    const std::string bytes = writer->GetOutputStdString();
    const VolumeRead read = ReadVolumeAt(this->folder.Write("noname", bytes));
    EXPECT_EQ(read.values, this->volume.values) << read.error;
    EXPECT_EQ(read.spacingMm, glm::dvec3(0.7, 1.1, 2.5));
    EXPECT_EQ(read.originMm, glm::dvec3(-10, -20, 30));
    for (std::size_t size = 10; size + 20 < bytes.size(); size += 20)
    {
      SCOPED_TRACE("cut to " + std::to_string(size));
      EXPECT_NE(ReadVolumeAt(this->folder.Write("cut.vtk", bytes.substr(0, size))).error, "");
    }
    EXPECT_NE(ReadVolumeAt(this->folder.Write("false.vtk",
                             Replaced(bytes, "DIMENSIONS 5 4 3", "DIMENSIONS 900 900 900")))
                .error.find("GB of voxels"),
      std::string::npos);
  }
}

TEST_F(VtkImageFiles, PiecesThatAreMissingOrLeaveGapsAreNamed)
{
  const std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PImageData\">\n<PImageData>\n"
                           "<Piece Source=\"piece.vti\"/>\n<Piece Source=\"other.vti\"/>\n"
                           "</PImageData>\n</VTKFile>\n";
  const std::string path = this->folder.Write("whole.pvti", text);
  this->folder.Write("piece.vti", VtiText(this->volume));
  EXPECT_NE(ReadVolumeAt(path).error.find("other.vti"), std::string::npos);
  this->folder.Write("other.vti", VtiText(this->volume, { 0, 0, 9 }));
  EXPECT_NE(ReadVolumeAt(path).error.find("gaps"), std::string::npos);
}

}
