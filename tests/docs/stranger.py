"""A reader of baked tables that has nothing but their folder: it evaluates the formulas of manifest.json as they are written there
(docs/tables.md)."""
import functools, json, re
import numpy as np
import OpenImageIO as oiio

FUNCTIONS = {"exp": np.exp, "sqrt": np.sqrt, "acos": np.arccos, "atan2": np.arctan2, "abs": np.abs, "max": np.maximum, "min": np.minimum,
             "dot": np.dot, "normalize": lambda k: k / np.linalg.norm(k), "pi": np.pi}
TOKEN = re.compile(r"\s*(?:(\d+\.?\d*(?:e-?\d+)?)|([A-Za-z_]\w*'?)(\(?)|(.))")


def python_of(expression):
    """Two factors side by side are a product, a name with its parenthesis at once is a function, ^ is a power."""
    parts, after_value, divided = [], False, [False]
    for number, name, call, sign in TOKEN.findall(expression):
        if (number or name or sign == "(") and after_value:
            if divided[-1]:
                raise SyntaxError(f"{expression}: divided by one factor or by both?")
            parts.append("*")
        parts.append(number or name.replace("'", "_prime") + call or {"^": "**"}.get(sign, sign))
        after_value = bool((number or name) and not call or sign and sign in ")]")
        if call or sign and sign in "([":
            divided.append(False)
        elif sign and sign in ")]":
            divided.pop()
        elif sign and sign in "/+-,":
            divided[-1] = sign == "/"
    return "".join(parts)


def statements(text):
    """(name, expression) of `name = expression; ...: remark`; none of a step that is but words."""
    said = text.split(": ")[0]
    return [tuple(part.strip().split(" = ")) for part in said.split(";")] if " = " in said else []


class Stranger:
    def __init__(self, folder):
        self.manifest = json.loads((folder / "manifest.json").read_text())
        self.pictures, self.compiled = {}, {}
        for table in self.manifest["tables"]:
            self.pictures[table["file"]] = oiio.ImageBuf(str(folder / table["file"])).get_pixels(oiio.FLOAT).astype(float)
        self.tables = {table["quantity"]: self.pictures[table["file"]] for table in self.manifest["tables"]}
        self.known = {**FUNCTIONS, **{key: np.array(value) if isinstance(value, list) else value
                                      for part in (self.manifest["constants"], self.manifest["material"], self.manifest.get("coat", {}).get("constants", {}))
                                      for key, value in part.items()}}
        if "fresnel_curve" in self.known:
            self.known["fresnel_curve"] = functools.partial(rows_at, self.known["fresnel_curve"])
        self.known.update(turns=turns, F=self.fresnel, p=self.p, q=self.q, T=lambda k: k * [-1, -1, 1], n=np.array([0.0, 0.0, 1.0]), R=self.albedo, mirrored=self.mirrored)
        for name, quantity in (("A", "A"), ("albedo", "albedo"), ("residual", "residual"), *((name, name) for name in ("whole", "factor", "brought", "spread"))):
            self.known[name] = lambda at, row, quantity=quantity: self.look_up(quantity, at, row)

        self.known["facet_albedo"] = lambda at, row: self.look_up("facet_albedo", at, row)
        self.known["facets"] = self.facets
        for name in ("coat_albedo", "coat_whole", "coat_inner"):
            self.known[name] = lambda at, row, name=name: self.look_up(name, at, row)
        for table in self.manifest["tables"]:
            if table["quantity"] in ("sum", "difference"):
                self.known[table["quantity"]] = lambda t, table=table: self.at_momentum(table, t)
            if table["quantity"] == "amplitude":
                self.known["amplitude"] = lambda x, y, table=table: self.at_momentum(table, (x, y))

    def value(self, expression, scope):
        if expression not in self.compiled:
            self.compiled[expression] = compile(python_of(expression), expression, "eval")
        with np.errstate(divide="ignore"):  # exp(-1/0) is 0
            return eval(self.compiled[expression], {"__builtins__": {}}, {**self.known, **scope})

    def follow(self, steps, scope):
        for step in steps:
            for name, expression in statements(step):
                scope[name.replace("'", "_prime")] = self.value(expression, scope)
        return scope

    def direction(self, k):
        scope = {"x": k[0], "y": k[1], "z": k[2]}
        steps = [step for step in self.manifest["evaluate"] if not step.startswith("k = ")]
        albedo = [self.manifest[key] for key in ("fresnel_at_n", "albedo_of_design") if key in self.manifest]
        return self.follow([*albedo[:-1], *steps, *albedo[-1:]], scope)

    def fresnel(self, cosine):
        return self.follow([step for step in self.manifest["brdf"] if re.search(r"(^|; )F = ", step)], {"c": cosine})["F"]

    def p(self, h):
        return sum(self.layer(layer, h) for layer in self.manifest["distribution"]["layers"])

    def q(self, h):
        return sum(np.array(layer["tint"]) * self.layer(layer, h) for layer in self.manifest["distribution"]["layers"])

    def layer(self, layer, h):
        x, y, z = (np.dot(layer["axis_" + axis], h) for axis in "xyz")
        said = layer["lobe"].split(": ")[0]
        formula = said.removesuffix(", also where z <= 0")
        if z <= 0 and formula == said:
            return 0
        scope = {"x": x, "y": y, "z": z, "i": layer["inverse_width"][0], "j": layer["inverse_width"][1],
                 "picture": lambda x, y, z: self.picture(layer["picture"], x, y, z)}
        if "curve" in layer:
            scope["curve"] = lambda theta: np.interp(theta, *np.array(layer["curve"]).T, left=0, right=0)
        value = self.value(formula, scope)
        if "modulation" in layer:
            words = self.manifest["distribution"]["modulation"].removeprefix("the lobe times ")
            scope.update(modulation_strength=layer["modulation_strength"],
                         picture=lambda x, y, z: self.picture(layer["modulation"], x, y, z))
            value *= self.value(words, scope)
        return layer["scale"] * value

    def picture(self, file, x, y, z):
        if z <= 0:
            return 0
        texels, side = self.pictures[file][:, :, 0], len(self.pictures[file])
        column, row = (np.clip(side * (1 + a / np.sqrt(1 + z)) / 2 - 0.5, 0, side - 1) for a in (x, -y))
        return bilinear(texels, column, row, min(int(row) + 1, side - 1))

    def look_up(self, quantity, at, azimuth):
        return self.look_into(self.tables[quantity], at, azimuth)

    def look_into(self, texels, at, azimuth):
        """The rules of `texels`; one number, or one for each colour."""
        symmetry = self.manifest["symmetry"]
        rows, columns = texels.shape[:2]
        row = azimuth * {"isotropic": 0, "quarter": rows - 1, "half": (rows - 1) / 2, "none": rows / 4}[symmetry]
        below = (int(row) + 1) % rows if symmetry == "none" else min(int(row) + 1, rows - 1)
        value = bilinear(texels, at * (columns - 1), row, below)
        return value if len(value) > 1 else value[0]

    def facets(self, a, b):
        """Class by class, term by term."""
        rows, (c, s) = len(self.tables["facet_albedo"]), self.known["axis"]
        here, there = self.direction(a), self.direction(b)
        (x1, y1), (x2, y2) = ((c * k[0] + s * k[1], c * k[1] - s * k[0]) for k in (a, b))
        apart = np.arctan2(y1, x1) - np.arctan2(y2, x2)
        side = lambda p, q: -1 if (p < 0) != (q < 0) else 1
        signs = [1, side(y1, y2), side(x1, x2), side(y1, y2) * side(x1, x2)]
        total = 0
        for term in range(self.known["facet_classes"] * self.known["facet_terms"]):
            own = self.tables["facet_terms"][term * rows:(term + 1) * rows]
            kind = term // self.known["facet_terms"]
            sign = np.cos(kind * apart) if self.manifest["symmetry"] == "isotropic" else signs[kind]
            total += sign * self.look_into(own, here["w"], here["psi"]) * self.look_into(own, there["w"], there["psi"])
        return max(total, 0)

    def at_momentum(self, table, t):
        """Of a vector along the surface, by what the table says of its axes."""
        texels, (a, b) = self.pictures[table["file"]][:, :, 0], self.known["axis"]
        x, y = a * t[0] + b * t[1], a * t[1] - b * t[0]
        if "in the place of" in table["x"] and (x < 0 or x == 0 and y < 0):
            x, y = -x, -y
        rule = lambda said: said.split(" from ")[0].split(",")[0]
        x, y = self.value(rule(table["x"]), {"x_prime": x, "y_prime": y}), self.value(rule(table["y"]) or "0", {"x_prime": x, "y_prime": y})
        column, row = ((v + 2) / 4 * (n - 1) if "-2" in said else v / 2 * (n - 1)
                       for v, n, said in ((x, texels.shape[1], table["x"]), (y, len(texels), table["y"])))
        column, row = min(column, texels.shape[1] - 1), min(row, len(texels) - 1)
        return bilinear(texels, column, row, min(int(row) + 1, len(texels) - 1))

    def albedo(self, k):
        plain = lambda k: self.direction(k)["R"]
        said = self.manifest.get("albedo_in_brdf", "R(k)")
        return self.value(said.split(": ")[0], {"k": k, "R": plain})

    def mirrored(self, k1, k2):
        steps = self.manifest["brdf"]
        until = next(index for index, step in enumerate(steps) if step.startswith("m = "))
        return self.follow([*steps[:until], steps[until].split("; ")[0]], self.pair(k1, k2))["m"]

    def pair(self, k1, k2):
        scope = {"k1": k1, "k2": k2}
        for index, k in (("1", k1), ("2", k2)):
            x, y = k[:2] if k[0] or k[1] else self.known["axis"]
            own = self.direction(k)
            scope.update({name + index: own[name] for name in ("g", "a", "e", "Fb", "Ef", "K") if name in own})
            scope.update({"x" + index: x, "y" + index: y, "z" + index: k[2]})
        return scope

    def brdf(self, k1, k2):
        if k1[2] <= 0 or k2[2] <= 0:
            return np.zeros(3)
        if "coat" in self.manifest:
            return self.coated(k1, k2)
        return self.beneath(k1, k2)

    def coated(self, k1, k2):
        coat, ends = self.manifest["coat"], {"k1": k1, "k2": k2}
        for index, k in (("1", k1), ("2", k2)):
            scope = self.follow(coat["inside"], {"x": k[0], "y": k[1], "z": k[2]})
            ends["inside" + index] = np.array([scope["xi"], scope["yi"], scope["zi"]])
            scope["rho"] = self.direction(ends["inside" + index])["rho"]
            self.follow(coat["evaluate"], scope)
            ends.update({name + index: scope[name] for name in ("t", "b", "gc")})
        ends["rho_b"] = self.beneath(ends.pop("inside1"), ends.pop("inside2"))
        return np.broadcast_to(self.follow(coat["brdf"], ends)["rho"], 3)

    def beneath(self, k1, k2):
        return np.broadcast_to(self.follow(self.manifest["brdf"], self.pair(k1, k2))["rho"], 3)


def rows_at(rows, place):
    """Straight lines between rows that stand at i/(n-1)."""
    return np.array([np.interp(place, np.linspace(0, 1, len(rows)), column) for column in rows.T])


def bilinear(texels, column, row, below):
    i, j = int(column), min(int(row), len(texels) - 1)
    right = min(i + 1, texels.shape[1] - 1)
    s, t = column - i, row - j
    above = texels[j, i] * (1 - s) + texels[j, right] * s
    return above * (1 - t) + (texels[below, i] * (1 - s) + texels[below, right] * s) * t


def turns(a, b):
    """As `evaluate` says it."""
    size = abs(a) + abs(b)
    t = (abs(b) - abs(a)) / size if size else -1
    u = 0.5 + t * (6 - t * t) / 10
    u = 2 - u if a < 0 else u
    return 4 - u if b < 0 else u
