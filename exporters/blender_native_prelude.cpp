// blender_native_prelude.cpp: the Python functions that every native Blender script begins with.
#include "exporters/blender.h"

namespace litmus {

const std::string_view kBlenderNativePrelude = R"python(
# ---- The usual way to build such a scene -----------------------------------------------------------
import math, os, sys
import bpy
from mathutils import Matrix, Vector

lamps = []              # in the order of the frames
ambient_colour = (0, 0, 0)


def new_scene(name, width, height, samples, rays):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    lamps.clear()
    scene = bpy.context.scene
    scene.name = name
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y = width * samples, height * samples
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_mode = "RGB"
    scene.render.image_settings.color_depth = "32"
    scene.render.use_persistent_data = True
    scene.cycles.samples = rays                 # an area lamp is sampled at random
    scene.cycles.filter_width = 0.01            # one point a pixel, as in the model
    scene.cycles.use_denoising = False
    scene.cycles.max_bounces = 0                # direct light only


def ambient(colour):
    global ambient_colour
    ambient_colour = colour


def material(name, ambient, diffuse, specular, shininess):
    """Diffuse and Glossy BSDF and, for ambient light, Emission. A highlight (h.n)^ns has the width of
    Beckmann's distribution with alpha^2 = 2 / (ns + 2), and its height face on with 8 / (ns + 2)."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    made.cycles.sample_as_light = False
    nodes, links = made.node_tree.nodes, made.node_tree.links
    nodes.clear()
    output = nodes.new("ShaderNodeOutputMaterial")
    matt = nodes.new("ShaderNodeBsdfDiffuse")
    matt.inputs["Color"].default_value = (*diffuse, 1)
    glow = nodes.new("ShaderNodeEmission")
    glow.inputs["Color"].default_value = (*(a * b for a, b in zip(ambient, ambient_colour)), 1)
    # Seen by the camera, lighting nothing else; the timeline turns it off with the second input.
    seen, gate = nodes.new("ShaderNodeLightPath"), nodes.new("ShaderNodeMath")
    gate.name, gate.operation = "Ambient", "MULTIPLY"
    links.new(seen.outputs["Is Camera Ray"], gate.inputs[0])
    links.new(gate.outputs[0], glow.inputs["Strength"])
    both = nodes.new("ShaderNodeAddShader")
    links.new(matt.outputs[0], both.inputs[0])
    links.new(glow.outputs[0], both.inputs[1])
    if any(specular):
        shiny = nodes.new("ShaderNodeBsdfGlossy")
        shiny.distribution = "BECKMANN"
        shiny.inputs["Color"].default_value = (*(8 / (shininess + 2) * x for x in specular), 1)
        shiny.inputs["Roughness"].default_value = (2 / (shininess + 2)) ** 0.25
        lit = both
        both = nodes.new("ShaderNodeAddShader")
        links.new(lit.outputs[0], both.inputs[0])
        links.new(shiny.outputs[0], both.inputs[1])
    links.new(both.outputs[0], output.inputs["Surface"])
    for i, node in enumerate((seen, gate, glow, matt, both, output)):
        node.location = (200 * i, 0 if node != matt else 150)
    return made


def finished(thing, name, finish, visible):
    thing.name = name
    thing.visible_camera = visible
    thing.data.materials.append(finish)


def sphere(name, finish, centre, radius, visible=True):
    bpy.ops.mesh.primitive_uv_sphere_add(segments=128, ring_count=64, radius=radius, location=centre)
    bpy.ops.object.shade_smooth()
    finished(bpy.context.object, name, finish, visible)


def box(name, finish, low, high, visible=True):
    bpy.ops.mesh.primitive_cube_add(size=1, location=[(a + b) / 2 for a, b in zip(low, high)],
                                    scale=[b - a for a, b in zip(low, high)])
    finished(bpy.context.object, name, finish, visible)


def add_mesh(name, finish, vertices, faces, visible):
    data = bpy.data.meshes.new(name)
    data.from_pydata(vertices, [], faces)
    thing = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(thing)
    finished(thing, name, finish, visible)
    return data


def plane(name, finish, corners, visible=True):
    add_mesh(name, finish, corners, [(0, 1, 2, 3)], visible)


def mesh(name, finish, vertices, triangles, normals="", visible=True):
    def rows(text, kind):
        return [tuple(map(kind, line.split())) for line in text.strip().splitlines()]
    data = add_mesh(name, finish, rows(vertices, float), rows(triangles, int), visible)
    if normals:
        data.polygons.foreach_set("use_smooth", [True] * len(data.polygons))
        data.use_auto_smooth = True
        data.normals_split_custom_set_from_vertices(rows(normals, float))


def add(name, data, place=(0, 0, 0), direction=None):
    thing = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(thing)
    thing.location = place
    if direction is not None:
        thing.rotation_euler = Vector(direction).to_track_quat("-Z", "Y").to_euler()
    return thing


def camera(eye, target, up, fov=None, height=None):
    data = bpy.data.cameras.new("Camera")
    data.sensor_fit = "VERTICAL"
    if fov is not None:
        data.angle = fov
    else:
        data.type, data.ortho_scale = "ORTHO", height
    back = (Vector(eye) - Vector(target)).normalized()
    right = Vector(up).cross(back).normalized()
    thing = add("Camera", data)
    thing.matrix_world = Matrix((right, back.cross(right), back)).transposed().to_4x4()
    thing.location = eye
    bpy.context.scene.camera = thing


def lamp(name, kind, energy, colour, place=(0, 0, 0), direction=None, shadows=True, **settings):
    data = bpy.data.lights.new(name, kind)
    data.energy, data.color = energy, colour
    data.cycles.cast_shadow = shadows
    for key, value in settings.items():
        setattr(data, key, value)
    lamps.append(add(name, data, place, direction))
    return lamps[-1]


def sun(name, direction, strength, colour, **more):
    lamp(name, "SUN", strength, colour, direction=direction, angle=0, **more)


def point(name, place, watts, colour, **more):
    lamp(name, "POINT", watts, colour, place, shadow_soft_size=0, **more)


def spot(name, place, direction, watts, colour, size, blend, **more):
    lamp(name, "SPOT", watts, colour, place, direction, shadow_soft_size=0, spot_size=size,
         spot_blend=blend, **more)


def area(name, place, axes, watts, colour, width, height, **more):
    """axes: right, up and the normal, into which the lamp shines."""
    thing = lamp(name, "AREA", watts, colour, shadows=more.pop("shadows", True), shape="RECTANGLE",
                 size=width, size_y=height)
    right, up, normal = map(Vector, axes)
    thing.matrix_world = Matrix((right, -up, -normal)).transposed().to_4x4()
    thing.location = place


def finish(name):
    """Frame 1 is ambient light, then one lamp a frame. Saves OUTDIR/name.blend and renders it."""
    arguments = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    folder = os.path.abspath(arguments[0] if arguments else ".")
    os.makedirs(folder, exist_ok=True)
    scene = bpy.context.scene
    scene.frame_start, scene.frame_end = 1, len(lamps) + 1
    scene.timeline_markers.new("ambient", frame=1)
    for i, thing in enumerate(lamps):
        scene.timeline_markers.new(thing.name, frame=i + 2)
        for frame, hidden in ((1, True), (i + 2, False), (i + 3, True)):
            thing.hide_render = hidden
            thing.keyframe_insert("hide_render", frame=frame)
    for made in bpy.data.materials:
        lit = made.node_tree.nodes["Ambient"].inputs[1]
        for frame, value in ((1, 1.0), (2, 0.0)):
            lit.default_value = value
            lit.keyframe_insert("default_value", frame=frame)
    for action in bpy.data.actions:
        for curve in action.fcurves:
            for key in curve.keyframe_points:
                key.interpolation = "CONSTANT"
    scene.frame_set(1)
    scene.render.filepath = os.path.join(folder, name + "_####")
    if "--no-blend" not in arguments:
        bpy.ops.wm.save_as_mainfile(filepath=os.path.join(folder, name + ".blend"), compress=True)
    bpy.ops.render.render(animation=True)
)python";

}  // namespace litmus
