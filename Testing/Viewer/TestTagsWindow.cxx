// The window of DICOM attributes, operated as a user does.

#include "Module/Files/PhantomDicom.h"
#include "Viewer/Open/TagsWindow.h"
#include "Waiting.h"

#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

class Tags : public testing::Test
{
protected:
  // Slices whose comments count them, with a private attribute and a sequence.
  void WriteSeries()
  {
    using phantom_dicom::Text;
    for (int slice = 0; slice < 3; ++slice)
    {
      DicomOptions options;
      options.instance = slice;
      auto elements = phantom_dicom::SliceElements(phantom::Stored(0), slice, options);
      elements[0x00204000] = Text("LT", "comment " + std::to_string(slice));
      elements[0x00190010] = Text("LO", "ACME 1.1");
      elements[0x00191001] = Text("LO", "private words");
      elements[0x00191002] = { "OB", std::string("\x01\xff", 2) };
      elements[0x00081140] =
        phantom_dicom::Sequence({ { { 0x00081155, Text("UI", "1.2.3.4.5") } } });
      this->folder.Write("scan/" + std::to_string(slice), phantom_dicom::FileBytes(elements));
    }
  }

  void Open(const std::string& name)
  {
    this->window =
      std::make_unique<TagsWindow>(FileSource{ this->folder.Path(name), std::nullopt }, nullptr);
    this->window->setAttribute(Qt::WA_DeleteOnClose, false);
    this->window->show();
  }

  bool HasLine(const QString& line)
  {
    return QTest::qWaitFor([&]
      { return ("\n" + this->window->SelectedText() + "\n").contains("\n" + line + "\n"); },
      MostMilliseconds);
  }

  int ShownCount() { return this->window->SelectedText().count('\n') + 1; }

  TemporaryFolder folder;
  std::unique_ptr<TagsWindow> window;
};

}

TEST_F(Tags, AreThoseOfTheChosenImagePrivateOnesToo)
{
  this->WriteSeries();
  this->Open("scan");
  ASSERT_TRUE(this->HasLine("(0020,4000)\tImageComments\tLT\tcomment 1"));
  EXPECT_TRUE(this->HasLine("(0010,0010)\tPatientName\tPN\tDoe^Jane"));
  EXPECT_TRUE(this->HasLine("(0019,1001)\t\tLO\tprivate words"));
  EXPECT_TRUE(this->HasLine("(0019,1002)\t\tOB\t01 ff"));
  EXPECT_TRUE(this->HasLine("(0008,1155)\tReferencedSOPInstanceUID\tUI\t1.2.3.4.5"));
  this->window->findChild<QSpinBox*>()->setValue(3);
  EXPECT_TRUE(this->HasLine("(0020,4000)\tImageComments\tLT\tcomment 2"));
}

TEST_F(Tags, AreFoundByWordsWithTheSequenceAroundThem)
{
  this->WriteSeries();
  this->Open("scan");
  ASSERT_TRUE(this->HasLine("(0010,0010)\tPatientName\tPN\tDoe^Jane"));
  auto* const search = this->window->findChild<QLineEdit*>();
  QTest::keyClicks(search, "jane 0010");
  EXPECT_EQ(this->ShownCount(), 1);
  search->clear();
  QTest::keyClicks(search, "1.2.3.4.5");
  EXPECT_EQ(this->ShownCount(), 3) << "the sequence, its item, and the attribute";
}

TEST_F(Tags, AreCopiedAsTheyAreSelected)
{
  this->WriteSeries();
  this->Open("scan");
  ASSERT_TRUE(this->HasLine("(0010,0010)\tPatientName\tPN\tDoe^Jane"));
  auto* const tree = this->window->findChild<QTreeWidget*>();
  const auto found = tree->findItems("PatientName", Qt::MatchExactly | Qt::MatchRecursive, 1);
  ASSERT_EQ(found.size(), 1);
  found.first()->setSelected(true);
  this->window->findChild<QPushButton*>("copy")->click();
  EXPECT_EQ(QApplication::clipboard()->text(), "(0010,0010)\tPatientName\tPN\tDoe^Jane");
}

TEST_F(Tags, OfAFileOfAnotherFormatAreASentence)
{
  this->folder.Write("a.nii", NiftiBytes(phantom::Stored(0)));
  this->Open("a.nii");
  const auto says = [this](const QString& words)
  {
    for (const QLabel* label : this->window->findChildren<QLabel*>())
    {
      if (label->text().contains(words))
      {
        return true;
      }
    }
    return false;
  };
  EXPECT_TRUE(QTest::qWaitFor(
    [&] { return says("a.nii\": expected DICOM images, found no DICOM file"); }, MostMilliseconds));
}
