// Lambert's (1.2): diffuse light only, which light.glsl has; no highlight.
float highlight(cosines c)
{
    return 0.0;
}
