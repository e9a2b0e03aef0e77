// How a light looks at the body: at a square across its way, from far; at the six faces of a cube
// around it, from near.  Depths are in mm, along the light.

struct View {
    vec4 u;      // a far light's square: its axes
    vec4 v;
    vec4 toward; // xyz toward a far light, w 0; w 1: a near light
    vec4 origin; // xyz the body's centre, w its radius; or where a near light stands
    vec4 extent; // x: no depth is larger
};

layout(std140, binding = 1) uniform Views {
    View view[8];
};

bool is_near(int i) {
    return view[i].toward.w == 1.0;
}

// From the plane that touches the body on the light's side, or from the near light itself.
float light_depth(int i, vec3 place) {
    vec3 way = place - view[i].origin.xyz;
    return is_near(i) ? length(way) : view[i].origin.w - dot(view[i].toward.xyz, way);
}

int facing(int i, vec3 place) {
    if (!is_near(i))
        return 0;
    vec3 way = place - view[i].origin.xyz, size = abs(way);
    int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return 2 * axis + (way[axis] < 0.0 ? 1 : 0);
}

// Clip space of one face, x right and y up as the light sees them: what goes into the material
// faces it.  Without depth: a distance from near is not linear over a face.
vec4 clip_from_world(int i, int face, vec3 place) {
    vec3 way = place - view[i].origin.xyz;
    if (!is_near(i))
        return vec4(dot(way, view[i].u.xyz), dot(way, view[i].v.xyz), 0.0, view[i].origin.w);
    int axis = face / 2, next = (axis + 1) % 3, last = (axis + 2) % 3;
    return face % 2 == 0 ? vec4(way[last], way[next], 0.0, way[axis])
                         : vec4(way[next], way[last], 0.0, -way[axis]);
}
