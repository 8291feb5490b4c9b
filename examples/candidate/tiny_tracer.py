#!/usr/bin/env python3
"""A tracer of spheres and planes, as small as can be, that litmus can check.

    tiny_tracer.py SCENE.json LIGHT OUTPUT.pfm [--full-angle]

SCENE.json is what `litmus export SCENE --to json` writes (exporters/scene.schema.json describes
it), LIGHT is "ambient" or the name of one of its lights. --full-angle plants a mistake: it takes a
spot's cutoff for the whole angle of the cone, where it is half of it.
"""
import json, math, struct, sys


def add(a, b, k=1.0): return (a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2])
def scale(a, k): return (k * a[0], k * a[1], k * a[2])
def dot(a, b): return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
def unit(a): return scale(a, 1 / math.sqrt(dot(a, a)))


def distances(shape, origin, direction):
    """Where the ray meets the surface, in multiples of its direction, nearest first."""
    if shape["shape"] == "plane":
        slope = dot(direction, shape["normal"])
        return [dot(add(shape["point"], origin, -1), shape["normal"]) / slope] if slope else []
    out = add(origin, shape["center"], -1)
    a, b, c = dot(direction, direction), dot(out, direction), dot(out, out) - shape["radius"] ** 2
    root = b * b - a * c
    return [(-b - math.sqrt(root)) / a, (-b + math.sqrt(root)) / a] if root >= 0 else []


def nearest_hit(scene, origin, direction):
    """(distance, object) of what the camera sees first, or None."""
    hits = [(t, i) for i, shape in enumerate(scene["objects"]) if shape["camera_visible"]
            for t in distances(shape, origin, direction) if t > 0]
    if not hits:
        return None
    t, i = min(hits)
    return t, scene["objects"][i]


def visible(scene, point, toward, reach):
    """Whether nothing lies between a surface point and a light; 1e-9 keeps off the surface itself."""
    return not any(1e-9 < t < reach for shape in scene["objects"]
                   for t in distances(shape, point, toward))


def attenuation(light, toward, distance, mistaken):
    """Slides 10, 11 and 16: weaker with distance, and within the cone of a spot."""
    r, linear, quadratic = light["range"], light["linear"], light["quadratic"]
    strength = r / (r + linear * distance) * r * r / (r * r + quadratic * distance * distance)
    if light["type"] == "spot":
        cutoff = light["cutoff_radians"] / (2 if mistaken else 1)
        alpha = math.acos(max(-1.0, min(1.0, -dot(toward, light["direction"]))))
        strength *= 1 - (alpha / cutoff) ** light["exponent"] if alpha <= cutoff else 0
    return strength


def shade(scene, light, material, point, normal, eye, mistaken):
    """Slide 5 for one light: the sum of kd*Id*(l.n) + ks*Is*(h.n)^ns over its points."""
    color = (0.0, 0.0, 0.0)
    for position in light.get("points", [None]):
        if position is None:   # directional
            toward, distance, strength = scale(light["direction"], -1), math.inf, 1.0
        else:
            way = add(position, point, -1)
            distance = math.sqrt(dot(way, way))
            toward = scale(way, 1 / distance)
            strength = light["share"] * attenuation(light, toward, distance, mistaken)
        cosine = dot(toward, normal)
        if cosine <= 0 or scene["shadows"] and not visible(scene, point, toward, distance):
            continue
        half = add(toward, eye)
        peak = max(0.0, dot(unit(half), normal)) ** material["shininess"] if dot(half, half) else 0.0
        color = tuple(c + strength * (kd * i * cosine + ks * s * peak) for c, kd, i, ks, s in
                      zip(color, material["diffuse"], light["diffuse"], material["specular"],
                          light["specular"]))
    return color


def seen(scene, light, u, v, mistaken):
    """The colour of the ray through (u, v), both from -1 to 1, right and up."""
    cam = scene["camera"]
    across = add(scale(cam["right"], u * cam["half_width"]), cam["up"], v * cam["half_height"])
    flat = cam["projection"] == "orthographic"
    origin = add(cam["eye"], across) if flat else tuple(cam["eye"])
    direction = tuple(cam["forward"]) if flat else unit(add(cam["forward"], across))
    hit = nearest_hit(scene, origin, direction)
    if hit is None:
        return (0.0, 0.0, 0.0)
    t, shape = hit
    material = scene["materials"][shape["material"]]
    if light is None:
        return tuple(k * i for k, i in zip(material["ambient"], scene["ambient"]))
    point = add(origin, direction, t)
    out = shape["normal"] if shape["shape"] == "plane" else unit(add(point, shape["center"], -1))
    normal = out if dot(out, direction) < 0 else scale(out, -1)
    return shade(scene, light, material, point, normal, scale(direction, -1), mistaken)


def main(scene_file, light_name, output, *flags):
    with open(scene_file) as file:
        scene = json.load(file)
    if scene["shading"] != "equation" or any(o["shape"] not in ("sphere", "plane")
                                             for o in scene["objects"]):
        print("tiny_tracer does the equation on spheres and planes only")
        return 77  # litmus: this scene is not for me
    light = next((l for l in scene["lights"] if l["name"] == light_name), None)
    width, height, n = (scene["image"][k] for k in ("width", "height", "samples"))
    with open(output, "wb") as file:
        file.write(b"PF\n%d %d\n-1.0\n" % (width, height))
        for y in reversed(range(height)):  # PFM begins with the bottom row
            for x in range(width):
                rays = [seen(scene, light, (2 * (x * n + i) + 1) / (width * n) - 1,
                             1 - (2 * (y * n + j) + 1) / (height * n), "--full-angle" in flags)
                        for j in range(n) for i in range(n)]
                file.write(struct.pack("<3f", *(sum(c) / n ** 2 for c in zip(*rays))))
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
