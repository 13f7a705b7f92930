// Scenes of carom in MyST Markdown and Jupyter Book: README.md says how to write them.
//
// All is made by the program `carom`, or by the one that the environment variable CAROM names. The document chooses scenes
// and the options checked below, each passed as an argument of its own and never through a shell.
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync } from 'node:fs';
import { dirname, join } from 'node:path';

const program = process.env.CAROM || 'carom';
const folder = 'carom-media'; // beside the page

class Refusal extends Error {}

// A scene is named as a file in or below the folder of its page.
function scenePath(name) {
  const plain = name.replace(/^\.\//, '');
  if (!/^[\p{L}\p{N}_][\p{L}\p{N}_\-./ ]*\.ya?ml$/u.test(plain) || /(^|\/)\.{0,2}(\/|$)/.test(plain))
    throw new Refusal(
      `a scene is named by letters, digits, spaces and -_./, as a file in or below the folder of the page, not ${JSON.stringify(name)}`);
  return `./${plain}`;
}

function checked(option, value, pattern, expected) {
  if (value === undefined || pattern.test(value)) return value;
  throw new Refusal(`:${option}: ${JSON.stringify(value)}: expected ${expected}`);
}

// What carom writes to standard output.
function call(page, command, scene, ...options) {
  try {
    return execFileSync(program, [command, scene, '--limits', 'classroom', ...options],
      { cwd: page, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'], maxBuffer: 1 << 26 });
  } catch (error) {
    if (error.status === undefined || error.status === null)
      throw new Refusal(`the program ${program} cannot be run (${error.code}); install carom, or name it in the environment variable CAROM`);
    throw new Refusal(error.stderr.trim());
  }
}

// What carom knows of a scene.
function factsOf(page, scene) {
  let json;
  try {
    json = call(page, 'check', scene, '--json');
  } catch (error) {
    call(page, 'check', scene, '--quiet'); // whose messages are for people
    throw error;
  }
  return JSON.parse(json)[0];
}

// The path, beside the page, of something that is made of a scene and `parts`, once.
function made(page, facts, parts, ending, make) {
  const key = createHash('sha256').update(JSON.stringify([facts.made_from, ...parts])).digest('hex').slice(0, 16);
  const path = `${folder}/${key}${ending}`;
  if (!existsSync(join(page, path))) make(path, `${folder}/${key}`);
  return path;
}

function picture(page, scene, facts, options) {
  const at = options.at ?? String(0.3 * facts.time);
  const theme = options.theme ? ['--theme', options.theme] : [];
  if (options.kind)
    return made(page, facts, ['figure', options.kind, at], `/${options.kind}.svg`, (path, base) =>
      call(page, 'figure', scene, '--quiet', '--kind', options.kind, '--at', at, '--formats', 'svg', '-o', base));
  return made(page, facts, ['still', at, ...theme], '.png', (path) =>
    call(page, 'still', scene, '--quiet', '--at', at, '-o', path, ...theme));
}

const text = (value) => ({ type: 'text', value });
const link = (url, words) => ({ type: 'link', url, static: true, children: [text(words)] });

function shown(page, data) {
  const { alt, film, width, label } = data.options ?? {};
  const at = checked('at', data.options?.at, /^(\d+\.?\d*|\.\d+)$/, 'a simulated time, as 12 or 2.5');
  const theme = checked('theme', data.options?.theme, /^(light|dark|print)$/, 'light, dark or print');
  const kind = checked('kind', data.options?.kind, /^[a-z][a-z-]*$/, 'the kind of a figure, as speed-histogram');
  const scene = scenePath(data.arg);
  const facts = factsOf(page, scene);
  const words = alt ?? facts.description;
  const image = { type: 'image', url: picture(page, scene, facts, { at, theme, kind }), alt: words, width };
  const children = [image];
  const after = [];
  if (!kind) {
    const path = made(page, facts, ['film', theme], '.mp4', (its) =>
      call(page, 'render', scene, '--quiet', '--words', '-o', its, ...(theme ? ['--theme', theme] : [])));
    if (film) {
      image.placeholder = true;
      children.unshift({ type: 'image', url: path, alt: words, width });
    }
    const transcript = path.replace(/mp4$/, 'transcript.txt');
    after.push({ type: 'paragraph', children: [link(path, 'Film'), text(' · '), link(transcript, 'Transcript of the film')] });
  }
  if (data.body?.length) children.push({ type: 'caption', children: data.body });
  const figure = { type: 'container', kind: 'figure', children };
  if (label) Object.assign(figure, { label, identifier: label.trim().toLowerCase().replace(/\s+/g, ' ') });
  return [figure, ...after];
}

const directive = {
  name: 'carom',
  doc: 'Shows a scene of carom: a picture of it, its film and its transcript.',
  arg: { type: String, required: true, doc: 'The file of the scene, in or below the folder of the page.' },
  options: {
    at: { type: String, doc: 'The simulated time of the picture; three tenths of the run without it.' },
    film: { type: Boolean, doc: 'Shows the film in place of the picture, where pages can.' },
    kind: { type: String, doc: 'Draws a figure of this kind instead, as speed-histogram.' },
    theme: { type: String, doc: 'light, dark or print.' },
    alt: { type: String, doc: 'What is seen, for those who cannot see it; without it, the description of the scene.' },
    width: { type: String, doc: 'The width, as 50% or 300px.' },
    label: { type: String, alias: ['name'], doc: 'For cross references.' },
  },
  body: { type: 'myst', doc: 'The caption.' },
  run(data, vfile) {
    try {
      return shown(dirname(vfile.path), data);
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      const message = vfile.message(`carom: ${error.message}`, data.node, 'carom');
      message.fatal = true;
      return [{ type: 'paragraph', children: [text(`carom: ${error.message}`)] }];
    }
  },
};

export default { name: 'carom', directives: [directive] };
