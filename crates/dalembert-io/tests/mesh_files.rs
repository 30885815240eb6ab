//! Meshes from STL and OBJ files.

use dalembert::mass::mesh_properties;
use dalembert::model::{Model, ShapeKind};
use dalembert_io::mesh_file::{MeshFileError, TriangleMesh, read_mesh};
use dalembert_io::model_file::{Parsed, parse_model, write_model};
use std::fs;
use std::path::{Path, PathBuf};

const STL: &str = include_str!("data/wedge.stl");

/// The same wedge: corners at the origin and at 1 on each axis.
const OBJ: &str = "\
# a wedge
mtllib none.mtl
o wedge
v 0 0 0
v 1 0 0 1.0
v 0 1 0
v 0 0 1 # the top
vn 0 0 -1
vt 0 0
f 1/1/1 3/1/1 2/1/1
f 1//1 2//1 4//1
f 1 4 3
f -3 -2 -1
";

fn folder(test: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .join("mesh-files")
        .join(test);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn read(test: &str, file: &str, content: &[u8]) -> Result<TriangleMesh, MeshFileError> {
    let folder = folder(test);
    fs::write(folder.join(file), content).unwrap();
    read_mesh(&folder, file)
}

/// The binary form of triangles.
fn binary(comment: &[u8], triangles: &[[[f32; 3]; 3]]) -> Vec<u8> {
    let mut bytes = comment.to_vec();
    bytes.resize(80, b' ');
    bytes.extend(u32::try_from(triangles.len()).unwrap().to_le_bytes());
    for triangle in triangles {
        bytes.extend([0; 12]);
        for number in triangle.as_flattened() {
            bytes.extend(number.to_le_bytes());
        }
        bytes.extend([7, 9]);
    }
    bytes
}

const WEDGE: [[[f32; 3]; 3]; 4] = {
    let [o, x, y, z] = [
        [0.0, -0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [-0.0, 0.0, 1.0],
    ];
    [[o, y, x], [o, x, z], [o, z, y], [x, y, z]]
};

#[test]
fn all_formats_give_the_same_wedge() {
    let solid = binary(b"solid that is not a text", &WEDGE);
    for (test, file, content) in [
        ("text", "wedge.stl", STL.as_bytes()),
        (
            "upper",
            "WEDGE.STL",
            STL.to_uppercase().replace("SOLID", "solid").as_bytes(),
        ),
        ("binary", "wedge.stl", &binary(b"", &WEDGE)),
        ("solid", "wedge.stl", &solid),
        ("obj", "wedge.obj", OBJ.as_bytes()),
        ("crlf", "wedge.obj", OBJ.replace('\n', "\r\n").as_bytes()),
    ] {
        let mesh = read(test, file, content).unwrap();
        assert_eq!(
            (mesh.vertices.len(), mesh.triangles.len()),
            (4, 4),
            "{test}"
        );
        // Closed, and of the volume 1/6 with its centre at a quarter (exact but for rounding).
        let wedge = mesh_properties(&mesh.vertices, &mesh.triangles).unwrap();
        assert!((wedge.mass - 1.0 / 6.0).abs() < 1e-15, "{test}");
        assert!(
            wedge.center.iter().all(|c| (c - 0.25).abs() < 1e-15),
            "{test}"
        );
    }
}

#[test]
fn triangles_that_are_lines_are_left_out() {
    let mut triangles = WEDGE.to_vec();
    triangles.push([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]);
    let mesh = read("lines", "m.stl", &binary(b"", &triangles)).unwrap();
    assert_eq!(mesh.triangles.len(), 4);
    assert!(mesh_properties(&mesh.vertices, &mesh.triangles).is_ok());
}

#[test]
fn what_is_no_mesh_is_told() {
    let whole = binary(b"", &WEDGE);
    let nan = binary(b"", &[WEDGE[0], [[f32::NAN; 3]; 3]]);
    for (file, content, message) in [
        (
            "m.step",
            &b""[..],
            "\"m.step\" is neither an .stl nor an .obj file",
        ),
        ("none", b"", "\"none\" is neither an .stl nor an .obj file"),
        (
            "m.stl",
            b"",
            "\"m.stl\" is not an STL file: it has only 0 bytes",
        ),
        (
            "m.stl",
            &whole[..whole.len() - 1],
            "\"m.stl\" is not an STL file: it does not start with \"solid\", and it has 283 bytes where a binary file of its 4 triangles has 284",
        ),
        (
            "m.stl",
            &nan,
            "\"m.stl\": triangle 2 has a number that is not finite",
        ),
        (
            "m.stl",
            b"solid a\nendsolid a\n",
            "\"m.stl\" has no triangles",
        ),
        (
            "m.stl",
            b"solid a\nouter loop\nvertex 0 0\n",
            "\"m.stl\", line 3: a corner needs three finite numbers, found \"vertex 0 0\"",
        ),
        (
            "m.stl",
            b"solid a\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n",
            "\"m.stl\", line 5: a face with 2 corners, only triangles can be read",
        ),
        (
            "m.stl",
            b"solid a\nvertex 0 0 0\n",
            "\"m.stl\" ends inside a face",
        ),
        (
            "m.stl",
            b"solid a\ntriangle\n",
            "\"m.stl\", line 2: \"triangle\" is not expected here",
        ),
        (
            "m.obj",
            b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n",
            "\"m.obj\", line 5: a face with 4 corners, only triangles can be read",
        ),
        (
            "m.obj",
            b"v 0 0 inf\n",
            "\"m.obj\", line 1: a corner needs three finite numbers, found \"v 0 0 inf\"",
        ),
        (
            "m.obj",
            b"v 0 0 0\nf 1 1 a\n",
            "\"m.obj\", line 2: \"a\" is not the number of a vertex",
        ),
        (
            "m.obj",
            b"v 0 0 0\nf 1 1 2\n",
            "\"m.obj\", line 2: there is no vertex 2, the file has 1",
        ),
        (
            "m.obj",
            b"v 0 0 0\nf 1 1 0\n",
            "\"m.obj\", line 2: there is no vertex 0, the file has 1",
        ),
        (
            "m.obj",
            b"v 0 0 0\nf 1 1 -2\n",
            "\"m.obj\", line 2: there is no vertex -2, the file has 1",
        ),
        ("m.obj", b"v 0 0 0\n", "\"m.obj\" has no triangles"),
        ("m.obj", b"\xff\xfe\n", "\"m.obj\" is not a text file"),
    ] {
        let error = read("wrong", file, content).unwrap_err();
        assert_eq!(error.to_string(), message);
        assert!(!error.help().is_empty());
    }
    for missing in ["missing.stl", "folder.stl"] {
        let folder = folder("unreadable");
        fs::create_dir_all(folder.join("folder.stl")).unwrap();
        let error = read_mesh(&folder, missing).unwrap_err().to_string();
        assert!(
            error.starts_with(&format!("cannot read \"{missing}\": ")),
            "{error}"
        );
    }
}

fn model(folder: Option<&Path>, file: &str) -> Parsed {
    let text = format!(
        "[model]\nname = \"m\"\nspace = \"spatial\"\n[[body]]\nname = \"a\"\n\
         shape = {{ kind = \"mesh\", file = \"{file}\" }}\n"
    );
    parse_model(&text, folder)
}

#[test]
fn the_file_stays_the_home_of_the_mesh() {
    let folder = folder("model");
    fs::write(folder.join("wedge.stl"), STL).unwrap();
    let parsed = model(Some(&folder), "wedge.stl");
    assert_eq!(parsed.diagnostics, []);
    let model: Model = parsed.model.unwrap();
    let ShapeKind::Mesh { vertices, .. } = &model.bodies[0].shape[0].kind else {
        panic!("{model:?}");
    };
    assert_eq!(vertices.len(), 4);
    let written = write_model(&model);
    assert!(!written.contains("vertices"), "{written}");
    assert_eq!(parse_model(&written, Some(&folder)).model, Some(model));
}

#[test]
fn a_mistake_is_shown_at_the_name_of_the_file() {
    let folder = folder("mistake");
    for (folder, file, message) in [
        (
            Some(folder.as_path()),
            "a.txt",
            "\"a.txt\" is neither an .stl nor an .obj file",
        ),
        (
            None,
            "a.stl",
            "the model was not read from a folder, so \"a.stl\" cannot be found",
        ),
    ] {
        let parsed = model(folder, file);
        let [found] = parsed.diagnostics.as_slice() else {
            panic!("{:?}", parsed.diagnostics);
        };
        assert_eq!(found.path, "body[0].shape[0].file");
        assert_eq!(
            found.message,
            format!("body \"a\": `shape[0].file`: {message}")
        );
        assert_eq!(parsed.model, None);
    }
}
