// The files of a folder that belong to a series: copies, deep folders, damaged files.
#include "DicomReading.h"
#include "DicomTags.h"

#include <vtkObject.h>

namespace
{

using phantom_dicom::Elements;
using phantom_dicom::Text;
using namespace dicom_tags;

class DicomFolders : public DicomReading
{
};

TEST_F(DicomFolders, ACopiedFolderIsReadOnce)
{
  for (int slice = 0; slice < 3; ++slice)
  {
    this->Write("a/" + std::to_string(slice), Slice(slice));
    this->Write("b/copy" + std::to_string(slice), Slice(slice));
  }
  this->Read();
  this->ExpectPhantom();
  this->ExpectWarning("copies of others: \"copy0\", \"copy1\" and 1 other.");
}

TEST_F(DicomFolders, ImagesThatShareAnIdentifierAreNoCopies)
{
  for (int slice = 0; slice < 3; ++slice)
  {
    Elements elements = Slice(slice);
    elements[0x00080018] = Text("UI", "1.2.3.77");
    this->Write(std::to_string(slice), elements);
  }
  this->Write("copy",
    []
    {
      Elements elements = Slice(1);
      elements[0x00080018] = Text("UI", "1.2.3.77");
      return elements;
    }());
  this->Read();
  this->ExpectPhantom();
  this->ExpectWarning("2 images have the identifier of another image, but other content");
  this->ExpectWarning("copies of others: \"copy\".");
}

TEST_F(DicomFolders, SeriesOfOneImageEachAreJoined)
{
  for (int slice = 0; slice < 3; ++slice)
  {
    Elements elements = Slice(slice);
    elements[0x0020000e] = Text("UI", "1.2.3." + std::to_string(slice));
    elements[0x00200052] = Text("UI", "1.2.52");
    this->Write(std::to_string(slice), elements);
  }
  this->Read();
  this->ExpectPhantom();
  this->ExpectWarning("3 series of one image each were joined");
}

TEST_F(DicomFolders, FoldersMayBeDeep)
{
  for (int slice = 0; slice < 3; ++slice)
  {
    this->Write("1/2/3/4/5/6/7/8/" + std::to_string(slice), Slice(slice));
  }
  std::string deeper;
  for (int level = 0; level < 40; ++level)
  {
    deeper += "d/";
  }
  this->Write(deeper + "slice", Slice(0, 70));
  this->Read();
  this->ExpectPhantom();
  this->ExpectWarning("was not searched; it is more than 32 levels deep.");
}

TEST_F(DicomFolders, AnIndexInASubfolderIsNotTakenForADamagedImage)
{
  for (int slice = 0; slice < 3; ++slice)
  {
    this->Write("disc/" + std::to_string(slice), Slice(slice));
  }
  this->folder.Write("scan/disc/DICOMDIR", DicomIndexBytes({ "0" }));
  this->Read();
  this->ExpectPhantom();
  EXPECT_EQ(this->Warnings(), "");
}

TEST_F(DicomFolders, ATruncatedSliceIsNamedAndTheOthersAreRead)
{
  for (int slice = 0; slice < 3; ++slice)
  {
    this->Write(std::to_string(slice), Slice(slice));
  }
  const std::string whole = phantom_dicom::FileBytes(Slice(0, 50));
  this->folder.Write("scan/cut", whole.substr(0, whole.size() - 6));
  this->folder.Write("scan/cutEarly", whole.substr(0, 400));
  this->Read();
  this->ExpectPhantom();
  this->ExpectWarning("scan/cut\" were left out: expected 40 bytes of pixels, found 34 before the "
                      "end of the file.");
  this->ExpectWarning("scan/cutEarly\" were left out");
}

TEST_F(DicomFolders, FaultsAreFoundWithoutVtksWarnings)
{
  Elements elements = Slice(0);
  elements.erase(Rows);
  this->Write("norows", elements);
  vtkObject::GlobalWarningDisplayOff();
  this->Read("norows");
  vtkObject::GlobalWarningDisplayOn();
  EXPECT_EQ(std::string(this->reader->GetErrorMessage()),
    "Cannot read \"" + this->folder.Path("scan/norows") +
      "\": expected the attribute Rows (0028,0010), found none.");
}

}
