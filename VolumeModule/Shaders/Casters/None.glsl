// No opaque geometry casts shadows.

Reach LeftByCasters(Reach reach, vec3 originGrid)
{
  return reach;
}

bool CastersLeave(vec3 originGrid, vec3 towards, float farMm)
{
  return true;
}
