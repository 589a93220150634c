#include "Resources/BlueNoiseTexture.h"

#include "Core/Quality/BlueNoise.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkType.h"

#include <vector>

namespace varimarch
{

void BlueNoiseTexture::MakeTile()
{
  if (this->tile.empty())
  {
    this->tile = BlueNoiseTile(Pixels);
  }
}

void BlueNoiseTexture::Upload(vtkOpenGLRenderWindow* window)
{
  if (this->texture->GetHandle())
  {
    return;
  }
  this->texture->SetContext(window);
  this->texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->texture->Create2DFromRaw(Pixels, Pixels, 1, VTK_UNSIGNED_SHORT, this->tile.data());
}

void BlueNoiseTexture::ReleaseTexture(vtkWindow* window)
{
  this->texture->ReleaseGraphicsResources(window);
}

void BlueNoiseTexture::Release(vtkWindow* window)
{
  this->ReleaseTexture(window);
  this->tile.clear();
}

}
