//! `polosa info`: what is in a model, and what is wrong with it.

use std::collections::HashSet;
use std::fmt::Write as _;
use std::process::ExitCode;

use clap::Args;
use polosa_math::Bounds;
use polosa_math::glam::DVec3;
use polosa_scene::import::{Part, SkippedItem};
use polosa_scene::topology::Topology;
use polosa_scene::{Colors, Mesh};
use serde_json::{Value, json};

use super::args::ModelArg;
use super::words::{counted, number};
use super::{complain, report, tell};
use crate::error::{Error, one_line};
use crate::guard::caught;
use crate::model::Source;

/// Tells what is in models: counts, bounds, materials, degenerate faces, open edges, watertight or not
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polosa info bunny.obj
  polosa info part.stl --json | jq .watertight
  polosa info *.stl --json | jq -r 'select(.watertight | not).name'")]
pub(super) struct InfoArgs {
    /// OBJ, STL, PLY, glTF or GLB files, `-` for standard input, or shapes such as shape:teapot. Each has a report
    /// of its own; a failure does not stop the rest, and the exit status is 1 at the end
    #[arg(required = true, value_name = "MODEL", value_parser = ModelArg::parser())]
    models: Vec<ModelArg>,

    /// The same as JSON, one line a model
    #[arg(long)]
    json: bool,
}

/// Prints what is in the models. A failure does not stop those that follow.
pub(super) fn run(args: &InfoArgs) -> Result<ExitCode, Error> {
    ModelArg::check_stdin(&args.models)?;
    let mut status = ExitCode::SUCCESS;
    for model in &args.models {
        let name = one_line(&model.name().to_string_lossy());
        let report = caught(&model.name(), || {
            let source = Source::open(model)?;
            let facts = Facts::of(&source);
            Ok(if args.json { json(&name, &source, &facts) } else { text(&name, &source, &facts) })
        });
        match report {
            Ok(report) => tell(&report, false),
            Err(error) => {
                complain(&error);
                status = ExitCode::from(error.exit_status());
            }
        }
    }
    Ok(status)
}

/// What is found out about a whole model: sums over its parts.
#[derive(Debug)]
struct Facts {
    parts: Vec<(Topology, Bounds)>,
    bounds: Bounds,
    edges: u64,
    open_edges: u64,
    non_manifold_edges: u64,
    degenerate: u64,
    not_finite: u64,
    watertight: bool,
    outward: bool,
}

impl Facts {
    fn of(source: &Source) -> Self {
        let parts: Vec<(Topology, Bounds)> = source
            .parts
            .iter()
            .map(|part| {
                let matrix = part.placement.matrix();
                let point = |p: [f32; 3]| matrix.transform_point3(p.map(f64::from).into());
                let mut bounds = Bounds::EMPTY;
                for &position in part.mesh.positions() {
                    bounds.insert(point(position));
                }
                (Topology::of(&part.mesh), bounds)
            })
            .collect();
        let sum = |of: fn(&Topology) -> usize| parts.iter().map(|(topology, _)| of(topology) as u64).sum();
        Self {
            bounds: parts.iter().fold(Bounds::EMPTY, |all, (_, bounds)| all.union(bounds)),
            edges: source
                .parts
                .iter()
                .zip(&parts)
                .map(|(part, (topology, _))| edges(&part.mesh, topology))
                .sum(),
            open_edges: sum(|topology| topology.open_edges),
            non_manifold_edges: sum(|topology| topology.non_manifold_edges),
            degenerate: sum(|topology| topology.degenerate),
            not_finite: sum(|topology| topology.non_finite),
            watertight: parts.iter().all(|(topology, _)| topology.watertight),
            outward: parts.iter().all(|(topology, _)| topology.outward),
            parts,
        }
    }
}

/// Parts that are listed one by one for people; the rest is counted.
const LISTED: usize = 20;

fn text(name: &str, source: &Source, facts: &Facts) -> String {
    let mut text = String::new();
    // Writing to a string does not fail.
    let _ = write_text(&mut text, name, source, facts);
    text
}

fn write_text(text: &mut String, name: &str, source: &Source, facts: &Facts) -> std::fmt::Result {
    let yes = |fact: bool| if fact { "yes" } else { "no" };
    writeln!(text, "{name}: {}", source.kind())?;
    let mut line = |what: &str, value: String| writeln!(text, "  {what:<20}{value}");
    line("parts", source.parts.len().to_string())?;
    line("vertices", source.vertices().to_string())?;
    line("triangles", source.triangles().to_string())?;
    line("edges", facts.edges.to_string())?;
    if let (false, min, max, size) =
        (facts.bounds.is_empty(), facts.bounds.min(), facts.bounds.max(), facts.bounds.size())
    {
        let numbers = |v: DVec3, between: &str| v.to_array().map(number).join(between);
        line("bounds", format!("({}) to ({})", numbers(min, ", "), numbers(max, ", ")))?;
        line("size", numbers(size, " × "))?;
    }
    let materials = materials(&source.parts);
    line("materials", if materials.is_empty() { "none".to_owned() } else { materials.join(", ") })?;
    line("colours", colors(&source.parts))?;
    line("degenerate faces", facts.degenerate.to_string())?;
    line("not finite faces", facts.not_finite.to_string())?;
    line("open edges", facts.open_edges.to_string())?;
    line("non-manifold edges", facts.non_manifold_edges.to_string())?;
    line("watertight", yes(facts.watertight).to_owned())?;
    line("faces outward", yes(facts.outward).to_owned())?;
    for remark in source.remarks() {
        line("note", one_line(&remark))?;
    }
    if source.parts.len() > 1 {
        for (part, (topology, _)) in source.parts.iter().zip(&facts.parts).take(LISTED) {
            let triangles = counted(part.mesh.triangles().len() as u64, "triangle", "triangles");
            let tight = if topology.watertight { "watertight" } else { "not watertight" };
            line("part", format!("{}: {triangles}, {tight}", one_line(&part.name)))?;
        }
        if source.parts.len() > LISTED {
            line("", format!("and {} more", source.parts.len() - LISTED))?;
        }
    }
    Ok(())
}

fn json(name: &str, source: &Source, facts: &Facts) -> String {
    let parts: Vec<Value> = source
        .parts
        .iter()
        .zip(&facts.parts)
        .map(|(part, (topology, bounds))| part_json(part, topology, bounds))
        .collect();
    let skipped: serde_json::Map<String, Value> = source
        .skipped
        .items()
        .iter()
        .map(|SkippedItem { kind, count, .. }| (kind.label().to_owned(), (*count).into()))
        .collect();
    let value = json!({
        "name": name,
        "format": source.kind(),
        "vertices": source.vertices(),
        "triangles": source.triangles(),
        "edges": facts.edges,
        "bounds": report::bounds(&facts.bounds),
        "materials": materials(&source.parts),
        "degenerate_faces": facts.degenerate,
        "not_finite_faces": facts.not_finite,
        "open_edges": facts.open_edges,
        "non_manifold_edges": facts.non_manifold_edges,
        "watertight": facts.watertight,
        "faces_outward": facts.outward,
        "parts": parts,
        "skipped": skipped,
        "notes": source.notes,
    });
    format!("{value}\n")
}

fn part_json(part: &Part, topology: &Topology, bounds: &Bounds) -> Value {
    json!({
        "name": part.name,
        "vertices": part.mesh.positions().len(),
        "triangles": part.mesh.triangles().len(),
        "edges": edges(&part.mesh, topology),
        "bounds": report::bounds(bounds),
        "materials": part.materials,
        "color": part.color.map(|color| color.to_string()),
        "degenerate_faces": topology.degenerate,
        "not_finite_faces": topology.non_finite,
        "open_edges": topology.open_edges,
        "non_manifold_edges": topology.non_manifold_edges,
        "inconsistent_edges": topology.inconsistent_edges,
        "pieces": topology.pieces,
        "watertight": topology.watertight,
        "faces_outward": topology.outward,
        "normals": part.mesh.normals().is_some(),
        "texture_coordinates": part.mesh.uvs().is_some(),
    })
}

/// The edges that are drawn: those of the file's polygons, else the triangles', equal places counted once.
fn edges(mesh: &Mesh, topology: &Topology) -> u64 {
    if mesh.has_own_edges() { mesh.edges().len() as u64 } else { topology.edges as u64 }
}

/// Names of materials, each once, in the order of the parts.
fn materials(parts: &[Part]) -> Vec<String> {
    let mut met = HashSet::new();
    let names = parts.iter().flat_map(|part| &part.materials).filter(|name| met.insert(name.as_str()));
    names.map(|name| one_line(name)).collect()
}

/// What the colours belong to, and which parts have one.
fn colors(parts: &[Part]) -> String {
    let mut kinds: Vec<String> = Vec::new();
    for part in parts {
        let kind = match (part.color, part.mesh.colors()) {
            (Some(color), _) => color.to_string(),
            (None, Colors::Vertex(_)) => "per vertex".to_owned(),
            (None, Colors::Face(_)) => "per face".to_owned(),
            _ => "none".to_owned(),
        };
        if !kinds.contains(&kind) {
            kinds.push(kind);
        }
    }
    kinds.join(", ")
}
