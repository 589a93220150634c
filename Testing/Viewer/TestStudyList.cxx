// The list of studies: its file, and its window, operated as a user does.

#include "Answers.h"
#include "Module/Files/PhantomDicom.h"
#include "Readers/VolumeFile.h"
#include "Viewer/Model/RecentScans.h"
#include "Viewer/Studies/StudyListWindow.h"
#include "Viewer/Studies/StudyTree.h"
#include "Waiting.h"

#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QTest>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

using namespace varimarch;

namespace
{

class StudyList : public testing::Test
{
protected:
  // A slice of a patient's series.
  void WriteImage(const std::string& file, const std::string& patient, const std::string& series,
    int instance, const std::string& description = "Head")
  {
    using phantom_dicom::Text;
    DicomOptions options;
    options.seriesUid = series;
    options.instance = instance;
    options.description = description;
    auto elements = phantom_dicom::SliceElements(phantom::Stored(0), instance % 3, options);
    elements[0x00100010] = Text("PN", patient);
    elements[0x00100020] = Text("LO", "id of " + patient);
    elements[0x0020000d] = Text("UI", "1.9." + std::to_string(patient.size()));
    elements[0x00080020] = Text("DA", "20261126");
    this->folder.Write("scans/" + file, phantom_dicom::FileBytes(elements));
  }

  QString Database() const { return QString::fromStdString(this->folder.Path("data/list.sqlite")); }
  QString Scans() const { return QString::fromStdString(this->folder.Path("scans")); }

  void Update(const TaskProgress& goesOn = [](double) { return true; })
  {
    this->index.Update(this->Scans(), goesOn);
  }

  TemporaryFolder folder;
  StudyIndex index{ this->Database() };
};

// A list that reads the folder of two patients.
class StudyListOnScreen : public StudyList
{
protected:
  StudyListOnScreen()
  {
    this->WriteImage("a/1", "DOE^JANE", "1.2.33", 0);
    this->WriteImage("a/2", "DOE^JANE", "1.2.33", 1);
    this->WriteImage("b/1", "MAJOR^TOM", "1.2.44", 0, "Thorax");
    this->window.show();
    this->window.Read({ this->Scans() });
  }

  // The texts of the first column that are shown.
  QStringList Shown() const
  {
    QStringList texts;
    for (QTreeWidgetItemIterator item(this->Tree()); *item; ++item)
    {
      const bool isHidden = (*item)->isHidden();
      if (!isHidden)
      {
        texts.append((*item)->text(0));
      }
    }
    return texts;
  }

  QTreeWidget* Tree() const { return this->window.findChild<QTreeWidget*>(); }

  bool Shows(const QStringList& texts)
  {
    return QTest::qWaitFor([&] { return this->Shown() == texts; }, MostMilliseconds);
  }

  const QStringList all = { "DOE, JANE", "Study without description", "Head", "MAJOR, TOM",
    "Study without description", "Thorax" };
  StudyListWindow window{ this->Database(), nullptr };
};

}

TEST(StudyTexts, AreThoseOfPeople)
{
  EXPECT_EQ(PersonText("Yamada^Tarou=山田^太郎"), "Yamada, Tarou");
  EXPECT_EQ(PersonText("=山田^太郎"), "山田, 太郎");
  EXPECT_EQ(PersonText("Doe"), "Doe");
  EXPECT_EQ(PersonText("Doe^Jane^M^Dr"), "Doe, Jane M Dr");
  EXPECT_EQ(PersonText(""), "");
  EXPECT_EQ(DateText("no date"), "no date");
  EXPECT_EQ(DateText("20261126"), QLocale().toString(QDate(2026, 11, 26), QLocale::ShortFormat));
}

TEST_F(StudyList, HoldsTheSeriesOfAFolderAndIsPrivate)
{
  this->WriteImage("x/1", "DOE^JANE", "1.2.33", 0);
  this->WriteImage("y/2", "DOE^JANE", "1.2.33", 1);
  this->folder.Write("scans/y/notes.txt", "not DICOM");
  this->Update();
  const QVector<IndexedSeries> all = this->index.Series();
  ASSERT_EQ(all.size(), 1);
  EXPECT_EQ(all[0].patientName, "DOE^JANE");
  EXPECT_EQ(all[0].patientId, "id of DOE^JANE");
  EXPECT_EQ(all[0].studyDate, "20261126");
  EXPECT_EQ(all[0].seriesUid, "1.2.33");
  EXPECT_EQ(all[0].imageCount, 2);
  EXPECT_EQ(all[0].path, this->Scans()) << "the folder of both files";
  const auto others = std::filesystem::perms::group_all | std::filesystem::perms::others_all;
  const auto permissions = std::filesystem::status(this->Database().toStdString()).permissions();
  EXPECT_EQ(permissions & others, std::filesystem::perms::none);
}

TEST_F(StudyList, ReadsOnlyWhatHasChanged)
{
  this->WriteImage("1", "DOE^JANE", "1.2.33", 0);
  this->WriteImage("2", "DOE^JANE", "1.2.33", 1);
  this->Update();
  // A file whose size and time stay is not read again.
  const std::string first = this->folder.Path("scans/1");
  const auto time = std::filesystem::last_write_time(first);
  this->WriteImage("1", "ROE^JOHN", "1.2.33", 0);
  std::filesystem::last_write_time(first, time);
  this->Update();
  ASSERT_EQ(this->index.Series().size(), 1);
  std::filesystem::last_write_time(first, time + std::chrono::seconds(2));
  this->Update();
  EXPECT_EQ(this->index.Series().size(), 2);
  std::filesystem::remove(this->folder.Path("scans/2"));
  this->Update();
  ASSERT_EQ(this->index.Series().size(), 1);
  EXPECT_EQ(this->index.Series()[0].patientName, "ROE^JOHN");
}

TEST_F(StudyList, KeepsWhatWasReadBeforeACancelAndGoesOn)
{
  for (int i = 0; i < 6; ++i)
  {
    this->WriteImage(std::to_string(i), "DOE^JANE", "1.2.33", i);
  }
  EXPECT_THROW(this->Update([](double part) { return part < 0.5; }), ReadCancelled);
  ASSERT_EQ(this->index.Series().size(), 1);
  const int before = this->index.Series()[0].imageCount;
  EXPECT_GT(before, 0);
  EXPECT_LT(before, 6);
  this->Update();
  EXPECT_EQ(this->index.Series()[0].imageCount, 6);
}

// A window that waits for the list while files are read would be told that it is locked.
TEST_F(StudyList, IsNotLockedWhileFilesAreRead)
{
  for (int i = 0; i < 3; ++i)
  {
    this->WriteImage(std::to_string(i), "DOE^JANE", "1.2.33", i);
  }
  double next = 0.1; // the files are found
  this->Update(
    [&](double part)
    {
      if (part > next)
      {
        next = part;
        this->index.Forget("/another/folder");
      }
      return true;
    });
  EXPECT_GT(next, 0.1) << "nothing was written meanwhile";
  EXPECT_EQ(this->index.Series().at(0).imageCount, 3);
}

TEST_F(StudyList, KeepsAFolderWhoseDiskIsAway)
{
  this->WriteImage("1", "DOE^JANE", "1.2.33", 0);
  this->Update();
  std::filesystem::rename(this->folder.Path("scans"), this->folder.Path("away"));
  EXPECT_THROW(this->Update(), std::runtime_error);
  EXPECT_EQ(this->index.Series().size(), 1);
}

TEST_F(StudyList, ForgetsAFolderWithoutATrace)
{
  this->WriteImage("1", "DOE^JANE", "1.2.33", 0);
  this->Update();
  const auto hasName = [this]
  { return this->folder.Bytes("data/list.sqlite").find("JANE") != std::string::npos; };
  ASSERT_TRUE(hasName());
  this->index.Forget(this->Scans());
  EXPECT_TRUE(this->index.Folders().isEmpty());
  EXPECT_FALSE(hasName());
}

TEST_F(StudyList, DoesNotGetAFolderBackThatIsForgottenAsItIsRead)
{
  this->WriteImage("1", "DOE^JANE", "1.2.33", 0);
  this->Update();
  this->WriteImage("2", "DOE^JANE", "1.2.33", 1);
  const auto forgets = [this](double part)
  {
    const bool isFound = part >= 0.1;
    if (isFound)
    {
      this->index.Forget(this->Scans());
    }
    return !isFound;
  };
  EXPECT_THROW(this->Update(forgets), ReadCancelled);
  EXPECT_TRUE(this->index.Folders().isEmpty());
  EXPECT_TRUE(this->index.Series().isEmpty());
}

TEST_F(StudyList, IsOverwrittenBeforeItIsRemoved)
{
  this->WriteImage("1", "DOE^JANE", "1.2.33", 0);
  this->Update();
  // Another name of the same bytes shows what a removed file leaves on the disk.
  std::filesystem::create_hard_link(
    this->folder.Path("data/list.sqlite"), this->folder.Path("data/left"));
  ASSERT_NE(this->folder.Bytes("data/left").find("JANE"), std::string::npos);
  this->index.RemoveAll();
  EXPECT_FALSE(QFile::exists(this->Database()));
  EXPECT_EQ(this->folder.Bytes("data/left").find("JANE"), std::string::npos);
}

TEST_F(StudyList, ThatIsDamagedIsASentence)
{
  this->folder.Write("data/list.sqlite", std::string(5000, 'x'));
  try
  {
    this->index.Series();
    FAIL() << "a damaged list was read";
  }
  catch (const std::runtime_error& problem)
  {
    EXPECT_NE(std::string(problem.what()).find("list.sqlite\" cannot be used"), std::string::npos)
      << problem.what();
  }
  this->index.RemoveAll();
  this->WriteImage("1", "DOE^JANE", "1.2.33", 0);
  this->Update();
  EXPECT_EQ(this->index.Series().size(), 1);
}

TEST_F(StudyListOnScreen, ShowsPatientsStudiesAndSeries)
{
  ASSERT_TRUE(this->Shows(this->all));
  const QTreeWidgetItem* const series = this->Tree()->topLevelItem(0)->child(0)->child(0);
  EXPECT_EQ(series->text(3), "CT");
  EXPECT_EQ(series->text(4), "2");
}

TEST_F(StudyListOnScreen, IsSearchedByWordsOfAnyLevel)
{
  ASSERT_TRUE(this->Shows(this->all));
  auto* const search = this->window.findChild<QLineEdit*>();
  QTest::keyClicks(search, "tom thorax");
  EXPECT_EQ(this->Shown(), (QStringList{ "MAJOR, TOM", "Study without description", "Thorax" }));
  search->clear();
  QTest::keyClicks(search, "jane thorax");
  EXPECT_TRUE(this->Shown().isEmpty());
}

TEST_F(StudyListOnScreen, OpensTheSeriesOfADoubleClick)
{
  ASSERT_TRUE(this->Shows(this->all));
  QSignalSpy wanted(&this->window, &StudyListWindow::SeriesWanted);
  QTreeWidget* const tree = this->Tree();
  const QPoint place = tree->visualItemRect(tree->topLevelItem(0)->child(0)->child(0)).center();
  QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, place);
  QTest::mouseDClick(tree->viewport(), Qt::LeftButton, {}, place);
  ASSERT_EQ(wanted.count(), 1);
  EXPECT_EQ(wanted.first()[0].toString(), this->Scans() + "/a");
  EXPECT_EQ(wanted.first()[1].toString(), DigestOfSeries("1.2.33"));
}

TEST_F(StudyListOnScreen, FindsChangesWhenAsked)
{
  ASSERT_TRUE(this->Shows(this->all));
  std::filesystem::remove_all(this->folder.Path("scans/a"));
  this->window.findChild<QPushButton*>("update")->click();
  EXPECT_TRUE(this->Shows(this->all.mid(3)));
}

TEST_F(StudyListOnScreen, IsRemovedByOneButton)
{
  ASSERT_TRUE(this->Shows(this->all));
  const Answers answers(QMessageBox::Yes, {});
  this->window.findChild<QPushButton*>("removeAll")->click();
  EXPECT_TRUE(this->Shows({}));
  EXPECT_FALSE(QFile::exists(this->Database()));
}

TEST_F(StudyListOnScreen, TellsThatAFolderCannotBeRemoved)
{
  ASSERT_TRUE(this->Shows(this->all));
  {
    auto other = QSqlDatabase::addDatabase("QSQLITE", "other");
    other.setDatabaseName(this->Database());
    ASSERT_TRUE(other.open());
    QSqlQuery writing(other);
    ASSERT_TRUE(writing.exec("BEGIN IMMEDIATE"));
    auto* const folders = this->window.findChild<QMenu*>();
    emit folders->aboutToShow();
    folders->actions().first()->trigger();
    const auto labels = this->window.findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(),
      [](const QLabel* label) { return label->text().contains("cannot be used"); }));
  }
  QSqlDatabase::removeDatabase("other");
  EXPECT_EQ(this->Shown(), this->all);
}
