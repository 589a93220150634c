#include "Readers/Parsing/VtkMessages.h"

#include <vtkLogger.h>
#include <vtkObject.h>

#include <gtest/gtest.h>

using namespace varimarch;

namespace
{

// Reports as VTK's own classes do.
class Reporter : public vtkObject
{
public:
  static Reporter* New() { return new Reporter; }
  vtkTypeMacro(Reporter, vtkObject);

  void Report()
  {
    vtkErrorMacro(<< "The file (a.nrrd) ends. It holds:\nnothing");
    vtkWarningMacro(<< "It is short");
  }
};

class VtkMessagesTest : public testing::Test
{
protected:
  VtkMessagesTest() { vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); }
  ~VtkMessagesTest() override { vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_INFO); }

  vtkNew<Reporter> reporter;
};

}

TEST_F(VtkMessagesTest, OfAnObservedObjectAreKeptWithoutTheirPlace)
{
  VtkMessages messages;
  messages.Observe(this->reporter);
  EXPECT_EQ(messages.FirstErrorOr("none"), "none");
  this->reporter->Report();
  ASSERT_EQ(messages.All().size(), 2u);
  EXPECT_EQ(messages.All()[0].kind, VtkMessage::Kind::Error);
  EXPECT_EQ(messages.FirstSentence(), "The file (a.nrrd) ends. It holds:\nnothing");
  EXPECT_EQ(messages.Errors(), std::vector<std::string>{ "The file (a.nrrd) ends. It holds:" });
  EXPECT_EQ(messages.Warnings(), std::vector<std::string>{ "It is short" });
  EXPECT_EQ(messages.FirstErrorOr("none"), "the fault \"The file (a.nrrd) ends\"");
}

TEST_F(VtkMessagesTest, ArePassedToTheLastObserverOfTheOutput)
{
  VtkMessages outer;
  outer.ObserveOutput();
  {
    VtkMessages inner;
    inner.ObserveOutput();
    this->reporter->Report();
    EXPECT_EQ(inner.All().size(), 2u);
    EXPECT_TRUE(outer.All().empty());
  }
  vtkOutputWindowDisplayText("plain");
  vtkGenericWarningMacro(<< "generic");
  ASSERT_EQ(outer.All().size(), 2u);
  EXPECT_EQ(outer.All()[0].kind, VtkMessage::Kind::Text);
  EXPECT_EQ(outer.All()[0].text, "plain");
  EXPECT_EQ(outer.All()[1].kind, VtkMessage::Kind::Warning);
  EXPECT_EQ(outer.All()[1].Sentence(), "generic");
}

TEST_F(VtkMessagesTest, OfAnObjectThatOutlivesThemAreLost)
{
  {
    VtkMessages messages;
    messages.Observe(this->reporter);
  }
  this->reporter->Report(); // fails this test if it is printed
}
