// Choosing one of several DICOM series with keys and mouse.

#include "Viewer/Open/SeriesPicker.h"

#include <QListWidget>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

class Picking : public testing::Test
{
protected:
  Picking() { this->picker.show(); }

  QListWidget* List() { return this->picker.findChild<QListWidget*>(); }

  SeriesPicker picker{ { { "1.1", "Thorax", "CT", 120, { 2, 2, { 255, 255, 255, 255 } } },
                         { "1.2", "", "MR", 1, {} } },
    nullptr };
  QSignalSpy chosen{ &this->picker, &SeriesPicker::Chosen };
};

}

TEST_F(Picking, ShowsWhatIsKnown)
{
  EXPECT_EQ(this->List()->item(0)->text(), "Thorax\nCT, images: 120");
  EXPECT_EQ(this->List()->item(1)->text(), "No description\nMR, images: 1");
  const QImage picture = this->List()->item(0)->icon().pixmap(100, 100).toImage();
  EXPECT_EQ(qGray(picture.pixel(picture.rect().center())), 255);
}

TEST_F(Picking, WithReturnChoosesTheFirst)
{
  QTest::keyClick(this->List(), Qt::Key_Return);
  ASSERT_EQ(this->chosen.count(), 1);
  EXPECT_EQ(this->chosen.first().first().toString(), "1.1");
  EXPECT_FALSE(this->picker.isVisible());
}

TEST_F(Picking, WithArrowsChoosesAnother)
{
  QTest::keyClick(this->List(), Qt::Key_Down);
  QTest::keyClick(this->List(), Qt::Key_Return);
  ASSERT_EQ(this->chosen.count(), 1);
  EXPECT_EQ(this->chosen.first().first().toString(), "1.2");
}

TEST_F(Picking, CanBeCancelled)
{
  QTest::keyClick(this->List(), Qt::Key_Escape);
  EXPECT_TRUE(this->chosen.isEmpty());
  EXPECT_FALSE(this->picker.isVisible());
}
