// The form for raw files: its guess, its message about the size, its preview.

#include "Viewer/Open/RawForm.h"
#include "Waiting.h"

#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

#include <fstream>

using namespace varimarch;

namespace
{

// Slices of 4 x 4 voxels: the first is bright in its left half, the last in its upper half.
std::string Voxels()
{
  std::string bytes;
  for (int i = 0; i < 48; ++i)
  {
    const bool isBright = i < 32 ? i % 4 < 2 : i < 40;
    bytes += isBright ? char(200) : char(0);
  }
  return bytes;
}

class Form : public testing::Test
{
protected:
  /// Shows the form for a file with these bytes before its voxels.
  RawForm& Show(const std::string& header, const QString& name = "scan_4x4x3_uint8.raw")
  {
    const QString path = this->folder.filePath(name);
    std::ofstream(path.toStdString(), std::ios::binary) << header << Voxels();
    this->form = std::make_unique<RawForm>(path, nullptr);
    this->form->show();
    return *this->form;
  }

  QString Words() { return this->form->findChild<QLabel*>("fit")->text(); }

  QPushButton* Open() { return this->form->findChild<QPushButton*>("open"); }

  QSpinBox* Box(const QString& name)
  {
    for (QSpinBox* box : this->form->findChildren<QSpinBox*>())
    {
      if (box->accessibleName() == name)
      {
        return box;
      }
    }
    return nullptr;
  }

  QImage Picture()
  {
    return this->form->findChild<QLabel*>("slicePicture")->pixmap(Qt::ReturnByValue).toImage();
  }

  /// True once the preview is bright only in its left (or upper) half.
  bool IsBrightAt(bool left)
  {
    const auto isSo = [&]
    {
      const QImage picture = this->Picture();
      const int x = picture.width();
      const int y = picture.height();
      return !picture.isNull() && qGray(picture.pixel(x / 8, y / 8)) > 128 &&
        (qGray(picture.pixel(x / 8, y - y / 8)) > 128) == left &&
        (qGray(picture.pixel(x - x / 8, y / 8)) > 128) != left;
    };
    return QTest::qWaitFor(isSo, MostMilliseconds);
  }

  QTemporaryDir folder;
  std::unique_ptr<RawForm> form;
};

}

TEST_F(Form, BeginsWithAGuessThatFits)
{
  RawForm& shown = this->Show("");
  EXPECT_EQ(shown.Layout().dimensions, (std::array<int, 3>{ 4, 4, 3 }));
  EXPECT_TRUE(this->Words().startsWith("The layout fits"));
  FileSource source;
  QObject::connect(
    &shown, &RawForm::Chosen, &shown, [&](const FileSource& chosen) { source = chosen; });
  QTest::keyClick(&shown, Qt::Key_Return);
  ASSERT_TRUE(source.raw);
  EXPECT_EQ(source.raw->dimensions[2], 3);
  EXPECT_EQ(source.path, this->folder.filePath("scan_4x4x3_uint8.raw").toStdString());
}

TEST_F(Form, ReportsExcessBytesAndSkipsThemAsAHeader)
{
  RawForm& shown = this->Show("1234567");
  EXPECT_EQ(this->Words(), "The file has 7 bytes more than this layout needs.");
  shown.findChild<QPushButton*>("takeHeader")->click();
  EXPECT_EQ(shown.Layout().headerBytes, 7);
  EXPECT_TRUE(this->Words().startsWith("The layout fits"));
  EXPECT_TRUE(this->IsBrightAt(true));
}

TEST_F(Form, OpensNoFileThatIsTooShort)
{
  this->Show("");
  this->Box("Slices")->setValue(4);
  EXPECT_EQ(this->Words(), "The layout does not fit: the file has 16 bytes less than it needs.");
  EXPECT_FALSE(this->Open()->isEnabled());
}

TEST_F(Form, ShowsTheSliceOfTheSlider)
{
  RawForm& shown = this->Show("");
  EXPECT_TRUE(this->IsBrightAt(true)) << "the slice in the middle";
  shown.findChild<QSlider*>()->setValue(2);
  EXPECT_TRUE(this->IsBrightAt(false));
}

TEST_F(Form, ShowsAtOnceWhatASettingChanges)
{
  this->Show("");
  EXPECT_TRUE(this->IsBrightAt(true));
  // With this offset, the previewed slice ends with the bright half of the last slice.
  this->Box("Bytes before the first voxel")->setValue(24);
  this->form->findChild<QSlider*>()->setValue(0);
  EXPECT_TRUE(QTest::qWaitFor(
    [this]
    {
      const QImage image = this->Picture();
      return !image.isNull() &&
        qGray(image.pixel(image.width() * 7 / 8, image.height() * 7 / 8)) > 128;
    },
    MostMilliseconds));
}

TEST_F(Form, CanBeClosedWhileItReads)
{
  this->Show("");
  this->form.reset();
}
