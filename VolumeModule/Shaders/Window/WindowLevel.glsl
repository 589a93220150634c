// Maps colours from level - window / 2 to level + window / 2 to those from black to white.

vec4 Windowed(vec4 picture)
{
  vec3 color = picture.rgb * windowScaleBias.x + picture.a * windowScaleBias.y;
  return vec4(clamp(color, 0.0, picture.a), picture.a);
}
