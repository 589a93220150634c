#ifndef Varimarch_Viewer_OpenGLProblem_h
#define Varimarch_Viewer_OpenGLProblem_h

#include <QString>

namespace varimarch
{

/// Says why windows cannot be drawn in: there is no OpenGL, or one before version 3.2, with which
/// VTK would crash. Empty if they can. Needs a QApplication.
QString OpenGLProblem();

/// True if the processor draws with OpenGL, by Mesa's llvmpipe. Needs a QApplication.
bool IsOpenGLOnProcessor();

}

#endif
