-- Scenes of carom in documents of pandoc, Quarto and Reveal.js: README.md says how to write them.
--
-- A film on pages that can play one, a picture elsewhere. All is made by the program `carom`, or by
-- the one that the environment variable CAROM names. The document chooses scenes and the options
-- checked below, each passed as an argument of its own and never through a shell.

local stringify = pandoc.utils.stringify

local program = os.getenv('CAROM') or 'carom'
local folder_name = 'carom-media'

-- Where films and pictures are written: beside the document that is made.
local output_folder = ((PANDOC_STATE.output_file or ''):match('^(.*)/[^/]*$'))
local folder = (output_folder and output_folder .. '/' or '') .. folder_name

local page_formats = {html = true, html4 = true, html5 = true, revealjs = true, slidy = true, s5 = true,
                      dzslides = true, slideous = true}
local is_pdf = (PANDOC_STATE.output_file or ''):match('%.pdf$') ~= nil
local is_page = page_formats[FORMAT] and not is_pdf
local picture_ending = ((FORMAT == 'latex' or FORMAT == 'beamer' or FORMAT == 'context') and 'pdf')
    or ((page_formats[FORMAT] or FORMAT == 'typst') and 'svg') or 'png'

local function fail(message)
    io.stderr:write('carom: ', message, '\n')
    os.exit(1)
end

-- Words of the document in a message, which is one line.
local function quoted(words) return '`' .. words:gsub('%c', ' '):sub(1, 80) .. '`' end

-- A scene is named as a file at or below the folder in which pandoc runs.
local function scene_path(address)
    local name = address:gsub('%%(%x%x)', function(code) return string.char(tonumber(code, 16)) end):gsub('^%./', '')
    if not name:match('^[%w\128-\255_][%w\128-\255_%-%./ ]*%.ya?ml$') or ('/' .. name):find('/%.%.?/') or name:find('//') then
        fail('a scene is named by letters, digits, spaces and -_./, as a file at or below the folder that pandoc runs in, '
             .. 'not ' .. quoted(name))
    end
    return './' .. name
end

local function choice(...)
    local words = {...}
    return function(value)
        for _, word in ipairs(words) do if value == word then return value end end
        return nil, 'one of ' .. table.concat(words, ', ')
    end
end

-- What a document may say of a scene, and how it is checked. `alt` is words.
local options = {
    at = function(value)
        if value:match('^%d+%.?%d*$') or value:match('^%.%d+$') then return value end
        return nil, 'a simulated time, as 12 or 2.5'
    end,
    film = choice('true', 'false'),
    autoplay = choice('true', 'false'),
    theme = choice('light', 'dark', 'print'),
    kind = function(value)
        if value:match('^%l[%l%-]*$') then return value end
        return nil, 'the kind of a figure, as speed-histogram'
    end,
    alt = function(value) return value end,
}

-- Takes them out of the attributes of an element.
local function taken_options(attributes)
    local taken = {}
    for name, check in pairs(options) do
        local value = attributes[name]
        if value ~= nil then
            local checked, expected = check(value)
            if checked == nil then fail(name .. '=' .. quoted(value) .. ': expected ' .. expected) end
            taken[name] = checked
            attributes[name] = nil
        end
    end
    return taken
end

local function exists(path)
    local file = io.open(path, 'rb')
    if file then file:close() end
    return file ~= nil
end

-- Calls carom, whose messages go to standard error. `scene` is a path or `-` with its text.
local function call(command, scene, text, arguments)
    local all = {command, scene, '--limits', 'classroom', table.unpack(arguments)}
    local done, result = pcall(pandoc.pipe, program, all, text or '')
    if done then return result end
    if type(result) == 'table' and result.error_code and result.error_code ~= 127 then
        if command == 'check' then pcall(pandoc.pipe, program, {'check', scene, '--limits', 'classroom', '--quiet'}, text or '') end
        fail('a scene of this document cannot be shown; see above')
    end
    fail('the program ' .. quoted(program) .. ' cannot be run; install carom, or name it in the environment variable CAROM')
end

-- The value of a member of the object that `carom check --json` prints, at the first level.
local function member(json, name)
    return json:match('\n    "' .. name .. '": "?([^\n]-)"?,?\n')
end

local function unescaped(json)
    return (json:gsub('\\(.)(%x?%x?%x?%x?)', function(letter, code)
        if letter == 'u' then return utf8.char(tonumber(code, 16)) end
        return (letter:match('[ntrbf]') and ' ' or letter) .. code
    end))
end

local checked_scenes = {}

-- A scene as carom has checked it, once in a document.
local function checked(scene, text)
    local known = checked_scenes[text or scene]
    if known then return known end
    local json = call('check', scene, text, {'--json'})
    known = {scene = scene, text = text, made_from = member(json, 'made_from'), until_time = tonumber(member(json, 'time')),
             description = unescaped(member(json, 'description')),
             language = member(json, 'language')}
    checked_scenes[text or scene] = known
    return known
end

-- The path, without its ending, of what is made of a scene and these options.
local function media_path(scene, parts)
    local key = pandoc.utils.sha1(scene.made_from .. ' ' .. table.concat(parts, ' '))
    return folder .. '/' .. key:sub(1, 16)
end

local function picture(scene, taken, ending)
    local theme = taken.theme or (not is_page and 'print') or 'scene'
    local at = taken.at or string.format('%.6g', 0.3 * scene.until_time)
    local base = media_path(scene, {'picture', theme, at, taken.kind or '', ending})
    if taken.kind then
        local path = base .. '/' .. taken.kind .. '.' .. ending
        if not exists(path) then
            call('figure', scene.scene, scene.text, {'--quiet', '--kind', taken.kind, '--at', at, '--formats', ending,
                                                     '-o', base})
        end
        return path
    end
    local path = base .. '.' .. ending
    if not exists(path) then
        local arguments = {'--quiet', '--at', at, '-o', path}
        if theme ~= 'scene' then table.move({'--theme', theme}, 1, 2, #arguments + 1, arguments) end
        call('still', scene.scene, scene.text, arguments)
    end
    return path
end

local function film(scene, taken)
    local base = media_path(scene, {'film', taken.theme or 'scene'})
    if not exists(base .. '.mp4') then
        local arguments = {'--quiet', '--words', '-o', base .. '.mp4'}
        if taken.theme then table.move({'--theme', taken.theme}, 1, 2, #arguments + 1, arguments) end
        call('render', scene.scene, scene.text, arguments)
    end
    return base
end

local function escaped(words)
    return (words:gsub('[&<>"\']', {['&'] = '&amp;', ['<'] = '&lt;', ['>'] = '&gt;', ['"'] = '&quot;', ["'"] = '&#39;'}))
end

-- The address, on the page, of a file in our folder.
local function address(path) return folder_name .. path:sub(#folder + 1) end

local has_moving_film = false

-- A player. Nothing moves before the viewer starts it, or, with `autoplay`, where reduced motion is asked for.
local function player(scene, taken, attributes, words)
    local base = film(scene, taken)
    local html = {'<video class="carom', taken.autoplay == 'true' and ' carom-autoplay" muted loop' or '"',
                  ' controls playsinline preload="metadata" style="max-width:100%"'}
    for _, side in ipairs({'width', 'height'}) do
        local value = attributes[side]
        if value and value:match('^%d+%.?%d*%a*%%?$') then
            if value:match('^%d+$') then
                table.insert(html, string.format(' %s="%s"', side, value))
            else
                html[3] = html[3]:gsub('"$', string.format(';%s:%s"', side, value))
            end
        end
    end
    table.insert(html, string.format(' poster="%s" aria-label="%s">', address(picture(scene, taken, 'png')), escaped(words)))
    table.insert(html, string.format('<source src="%s" type="video/mp4">', address(base .. '.mp4')))
    for _, track in ipairs({'captions', 'chapters', 'descriptions'}) do
        local path = base .. '.' .. track .. '.vtt'
        if exists(path) then
            table.insert(html, string.format('<track kind="%s" src="%s" srclang="%s" label="%s"%s>', track, address(path),
                                             scene.language, track, track == 'captions' and ' default' or ''))
        end
    end
    table.insert(html, string.format('</video><br><a class="carom-transcript" href="%s">Transcript of the film</a>',
                                     address(base .. '.transcript.txt')))
    has_moving_film = has_moving_film or taken.autoplay == 'true'
    return pandoc.RawInline('html', table.concat(html))
end

-- The inline that shows a scene. An image keeps its caption, title, identifier and classes.
local function shown(image, scene)
    local taken = taken_options(image.attributes)
    local words = taken.alt or stringify(image.caption)
    if words == '' then words = scene.description end
    if is_page and taken.film ~= 'false' and not taken.kind then return player(scene, taken, image.attributes, words) end
    local path = picture(scene, taken, picture_ending)
    image.src = is_page and address(path) or path
    if #image.caption == 0 then image.caption = {pandoc.Str(words)} end
    if is_page then image.attributes.alt = words end
    return image
end

local function is_scene(image) return image.src:match('%.ya?ml$') ~= nil end

local function image_shown(image) return shown(image, checked(scene_path(image.src))) end

-- The figure of an image that stands alone in a paragraph, for versions of pandoc that have no blocks for figures and write
-- them only of images.
local function figure_of_player(image, inline)
    local id = image.identifier ~= '' and string.format(' id="%s"', escaped(image.identifier)) or ''
    return {pandoc.RawBlock('html', '<figure' .. id .. '>'), pandoc.Plain({inline}), pandoc.RawBlock('html', '<figcaption>'),
            pandoc.Plain(image.caption), pandoc.RawBlock('html', '</figcaption></figure>')}
end

local function is_old_figure(image) return image.title:sub(1, 4) == 'fig:' end

local function paragraph(block)
    local image = #block.content == 1 and block.content[1]
    if not image or image.t ~= 'Image' or not is_old_figure(image) or not is_scene(image) then return nil end
    local inline = image_shown(image)
    if inline.t == 'Image' then return pandoc.Para({inline}) end
    return figure_of_player(image, inline)
end

local function code_block(block)
    if not block.classes:includes('carom') then return nil end
    local scene = checked('-', block.text)
    local caption = block.attributes.caption
    block.attributes.caption = nil
    local words = caption and {pandoc.Str(caption)} or {}
    local image = pandoc.Image(words, 'scene.yaml', caption and not pandoc.Figure and 'fig:' or '',
                               pandoc.Attr(block.identifier, {}, block.attributes))
    if caption and pandoc.Figure then
        image.identifier = ''
        return pandoc.Figure({pandoc.Plain({shown(image, scene)})}, {long = {pandoc.Plain(words)}}, pandoc.Attr(block.identifier))
    end
    local inline = shown(image, scene)
    if caption and inline.t ~= 'Image' then return figure_of_player(image, inline) end
    return pandoc.Para({inline})
end

-- Films that begin by themselves, unless the viewer has asked for reduced motion.
local script = [[<script>
if (!matchMedia('(prefers-reduced-motion: reduce)').matches)
  for (const film of document.querySelectorAll('video.carom-autoplay')) film.play();
</script>]]

local function add_script(document)
    if not has_moving_film then return nil end
    document.blocks:insert(pandoc.RawBlock('html', script))
    return document
end

return {
    {Para = paragraph, CodeBlock = code_block},
    {Image = function(image) if is_scene(image) then return image_shown(image) end end},
    {Pandoc = add_script},
}
