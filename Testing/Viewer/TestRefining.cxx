// The corner of a view while the voxels of a volume in its file follow its coarse level.

#include "TorsoWindow.h"

#include <QFile>
#include <QStringList>

#include <cmath>
#include <cstdint>
#include <vector>

using namespace varimarch;

namespace
{

const QString Remedy = "\nLess error takes long, since its voxels do not fit in the memory:\n"
                       "allow more in the menu File, or zoom in.";

class RefiningView : public Window
{
protected:
  static constexpr int Side = 64;

  // Opens fog in waves within a memory, and collects the corner's texts until the fog is refined.
  QStringList ReportsWithin(double megabytes, double errorTolerance)
  {
    this->WriteVoxels();
    this->Write("scene.json",
      QStringLiteral(R"({ "volume": { "file": "waves.raw", "memory": %1,
        "raw": { "dimensions": [%2, %2, %2], "type": "int16" } },
      "look": { "colors": [{ "value": 0, "rgb": [1, 1, 1] }],
        "opacities": [{ "value": 0, "opacity": 0 }, { "value": 1000, "opacity": 0.03 }],
        "shading": { "enabled": false } },
      "render": { "detail": "refined", "errorTolerance": %3 } })")
        .arg(megabytes)
        .arg(Side)
        .arg(errorTolerance)
        .toUtf8());
    QStringList reports;
    this->View()->DrawInThread();
    QObject::connect(this->View(), &VolumeView::Refined, this->View(),
      [&] { reports << this->View()->Report().section('\n', 1); });
    this->window.Open(this->Path("scene.json"));
    EXPECT_TRUE(QTest::qWaitFor(
      [&] { return !reports.isEmpty() && reports.last().contains("refined"); }, MostMilliseconds));
    this->View()->disconnect(SIGNAL(Refined(double)));
    return reports;
  }

private:
  void Write(const char* name, const QByteArray& bytes) const
  {
    QFile file(this->Path(name));
    ASSERT_TRUE(file.open(QFile::WriteOnly));
    file.write(bytes);
  }

  void WriteVoxels() const
  {
    std::vector<std::int16_t> voxels;
    for (int i = 0; i < Side * Side * Side; ++i)
    {
      const int x = i % Side;
      const int y = i / Side % Side;
      voxels.push_back(std::int16_t(500.0 + 300.0 * std::sin(0.2 * x) * std::cos(0.25 * y)));
    }
    this->Write("waves.raw",
      { reinterpret_cast<const char*>(voxels.data()), int(sizeof(voxels[0]) * voxels.size()) });
  }
};

}

TEST_F(RefiningView, TellsThatFinerVoxelsDoNotFit)
{
  const QStringList reports = this->ReportsWithin(0.8, 1.0 / 64.0);
  EXPECT_EQ(reports.filter(Remedy).filter("refining").size(), 1) << "images that are not the last";
  EXPECT_EQ(reports.last(), "error at most 1/64, refined");
}

TEST_F(RefiningView, TellsTheErrorUntilTheToleranceIsKept)
{
  const QStringList reports = this->ReportsWithin(2.0, 1.0 / 16.0);
  EXPECT_TRUE(reports.filter("memory").isEmpty());
  EXPECT_GT(reports.filter("refining").size(), 0);
  EXPECT_EQ(reports.last(), "error at most 1/16, refined");
}

TEST_F(RefiningView, TellsTheRemedyWhileAnImageOfVoxelsThatDoNotFitIsDrawn)
{
  PictureNumbers numbers = { 0, 8, 0.05 };
  const auto report = [&] { return PictureReport(numbers, MapperKind::Varimarch, {}, 0.2); };
  EXPECT_EQ(report(), "200 ms\nrefining, 40 %");
  numbers.voxelsFit = false;
  EXPECT_EQ(report(), "200 ms\nrefining, 40 %" + Remedy);
}

// A bound is a promise about the pixels that are shown.
TEST_F(RefiningView, TellsABoundOnlyOfPixelsThatHaveOne)
{
  PictureNumbers numbers = { 1, 8, 0.125, 1.0 / 64.0 };
  const auto report = [&]
  { return PictureReport(numbers, MapperKind::Varimarch, {}, 0.2).section('\n', 1); };
  EXPECT_EQ(report(), "error at most 1/64");
  numbers.isMoving = true;
  EXPECT_EQ(report(), "error at most 1/64") << "held still after a fine image";
  numbers.isFine = false;
  EXPECT_EQ(report(), "moving");
  numbers.isMoving = false;
  EXPECT_EQ(report(), "refining, 0 %");
  numbers.isOutOfDate = true;
  EXPECT_EQ(report(), "out of date");
  numbers.isFine = true;
  EXPECT_EQ(report(), "out of date");
}
